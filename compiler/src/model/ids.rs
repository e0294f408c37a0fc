//! Words that stand for things.

use std::collections::BTreeMap;

/// A name in kebab case: letters and digits of ASCII, everything else a dash.
pub(crate) fn id(name: &str) -> String {
    let mut id = String::with_capacity(name.len());
    for c in name.chars() {
        if c.is_ascii_alphanumeric() {
            id.push(c.to_ascii_lowercase());
        } else if !id.is_empty() && !id.ends_with('-') {
            id.push('-');
        }
    }
    let id = id.trim_end_matches('-');
    if id.is_empty() { "unnamed".to_owned() } else { id.to_owned() }
}

/// The ids that siblings have, each with the first number that may still be free behind it.
#[derive(Debug, Default)]
pub(crate) struct Siblings(BTreeMap<String, u32>);

impl Siblings {
    /// An id that no sibling has yet: the id itself, or the id with the first free number.
    pub(crate) fn claim(&mut self, name: &str) -> String {
        let mut id = id(name);
        if let Some(first) = self.0.get(&id).copied() {
            let (number, numbered) = (first..)
                .map(|number| (number, format!("{id}-{number}")))
                .find(|(_, numbered)| !self.0.contains_key(numbered))
                .unwrap_or_default();
            self.0.insert(std::mem::replace(&mut id, numbered), number.saturating_add(1));
        }
        self.0.insert(id.clone(), 2);
        id
    }
}
