//! Words as people write them.

use std::ops::RangeInclusive;

/// The words of a question as one.
#[derive(Clone)]
pub(super) struct Phrase(String);

/// A number as it was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Number {
    pub(super) value: i64,
    /// Whether it was written in hex, as indices and codes are.
    pub(super) is_hex: bool,
}

impl Phrase {
    pub(super) fn new(words: &[String]) -> Self {
        let words = words.iter().flat_map(|word| word.split_whitespace());
        let words = words.map(|word| if number(word).is_some() { word.to_owned() } else { plain(word) });
        Self(words.collect::<Vec<_>>().join("-"))
    }

    pub(super) fn text(&self) -> &str {
        &self.0
    }

    /// What follows `word`, if the phrase begins with it.
    pub(super) fn behind(&self, word: &str) -> Option<Self> {
        let rest = self.0.strip_prefix(&plain(word))?;
        if rest.is_empty() {
            Some(Self(String::new()))
        } else {
            rest.strip_prefix('-').map(|rest| Self(rest.to_owned()))
        }
    }

    /// The number that it is.
    pub(super) fn number(&self) -> Option<Number> {
        number(&self.0)
    }

    /// The phrase before a colon, and the number of an entry behind it.
    pub(super) fn entry(&self) -> Option<(Self, i64)> {
        let (object, subindex) = self.0.rsplit_once(':')?;
        let subindex = i64::from_str_radix(subindex.trim_start_matches("0x"), 16).ok()?;
        Some((Self(object.to_owned()), subindex))
    }

    /// Whether it is this name.
    pub(super) fn is(&self, name: &str) -> bool {
        self.0 == plain(name)
    }

    /// Whether its words stand in this name.
    pub(super) fn is_in(&self, name: &str) -> bool {
        !self.0.is_empty() && format!("-{}-", plain(name)).contains(&format!("-{}-", self.0))
    }
}

/// A name in one spelling: `Position actual value` is `position-actual-value`.
pub(super) fn plain(name: &str) -> String {
    let keep = |char: char| char.is_alphanumeric() || char == ':';
    let parts = name.split(|char| !keep(char)).filter(|part| !part.is_empty());
    parts.map(str::to_lowercase).collect::<Vec<_>>().join("-")
}

/// The number that a word is.
pub(super) fn number(word: &str) -> Option<Number> {
    let digits = word.strip_prefix("0x").or_else(|| word.strip_prefix("0X"));
    let value = match digits {
        Some(digits) => i64::from_str_radix(digits, 16).ok()?,
        None => word.parse().ok()?,
    };
    Some(Number { value, is_hex: digits.is_some() })
}

/// The numbers that a key stands for: itself, or those of a range such as `0xFF00..=0xFFFF`.
pub(super) fn numbers(key: &str) -> Option<RangeInclusive<i64>> {
    let (first, last) = key.split_once("..=").unwrap_or((key, key));
    Some(number(first)?.value..=number(last)?.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn phrase(text: &str) -> Phrase {
        Phrase::new(&[text.to_owned()])
    }

    #[test]
    fn spelling_does_not_matter() {
        assert!(phrase("Position  actual value").is("position-actual-value"));
        assert!(phrase("0x607a").number() == phrase("0x607A").number());
        assert_eq!(
            phrase("mode -1").behind("mode").and_then(|rest| rest.number()).map(|it| it.value),
            Some(-1)
        );
        assert!(phrase("modest").behind("mode").is_none());
    }

    #[test]
    fn subindices_are_hex_as_in_addresses() {
        assert_eq!(phrase("0x60FE:1A").entry().map(|(_, subindex)| subindex), Some(26));
        assert!(phrase("digital outputs:1").entry().is_some_and(|(object, _)| object.is("digital-outputs")));
    }

    #[test]
    fn ranges_are_all_their_numbers() {
        assert!(numbers("0xFF00..=0xFFFF").is_some_and(|range| range.contains(&0xFF7F)));
        assert_eq!(numbers("fault"), None);
    }
}
