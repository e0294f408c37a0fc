//! From ids to identifiers, whatever the language.

use std::collections::BTreeMap;

/// The runs of letters and digits of an id.
pub(super) fn words(id: &str, case: impl Fn(&str) -> String) -> Vec<String> {
    id.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).map(case).collect()
}

/// The id in `snake_case`; empty if no letter or digit is in it.
pub(super) fn snake(id: &str) -> String {
    words(id, str::to_ascii_lowercase).join("_")
}

/// The id in `SHOUTING_CASE`.
pub(super) fn shout(id: &str) -> String {
    words(id, str::to_ascii_uppercase).join("_")
}

/// The id in `UpperCamelCase`.
pub(super) fn camel(id: &str) -> String {
    let mut text = String::new();
    for word in words(id, str::to_owned) {
        // two numbers side by side would read as one
        if text.ends_with(|c: char| c.is_ascii_digit()) && word.starts_with(|c: char| c.is_ascii_digit()) {
            text.push('_');
        }
        let (first, rest) = word.split_at(1.min(word.len()));
        text.push_str(&first.to_ascii_uppercase());
        text.push_str(rest);
    }
    text
}

/// Texts of one namespace, each only once, with the first number that may still be free behind it.
#[derive(Debug, Default)]
pub(super) struct Claimed(BTreeMap<String, u32>);

impl Claimed {
    /// A namespace in which these are taken.
    pub(super) fn with(taken: &[&str]) -> Self {
        Self(taken.iter().map(|name| ((*name).to_owned(), 2)).collect())
    }

    /// The text, or if it is taken, what `numbered` makes of it with the first free number.
    pub(super) fn claim(&mut self, wanted: String, numbered: impl Fn(u32) -> String) -> String {
        let mut name = wanted;
        if let Some(first) = self.0.get(&name).copied() {
            let free = (first..).map(|number| (number, numbered(number)));
            let mut free = free.skip_while(|(_, name)| self.0.contains_key(name));
            let (number, other) = free.next().unwrap_or((first, name.clone()));
            self.0.insert(std::mem::replace(&mut name, other), number.saturating_add(1));
        }
        self.0.insert(name.clone(), 2);
        name
    }

    /// Whether the text is taken.
    pub(super) fn has(&self, name: &str) -> bool {
        self.0.contains_key(name)
    }
}
