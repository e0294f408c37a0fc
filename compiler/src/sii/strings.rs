//! The names, each once.

use super::Category;

/// Type of the category.
const STRINGS: u16 = 10;

/// Texts by number, from 1 on.
#[derive(Debug, Default)]
pub(super) struct Strings {
    texts: Vec<Vec<u8>>,
    left_out: bool,
}

impl Strings {
    /// The number of a text; 0, which is none, for no text, and for what is longer than a byte can say.
    pub(super) fn number(&mut self, text: &str) -> u8 {
        let text = visible(text);
        if text.is_empty() || u8::try_from(text.len()).is_err() {
            return 0;
        }
        let known = self.texts.iter().position(|known| *known == text);
        let place = known.unwrap_or(self.texts.len());
        let Some(number) = u8::try_from(place).ok().and_then(|place| place.checked_add(1)) else {
            self.left_out = true;
            return 0;
        };
        if known.is_none() {
            self.texts.push(text);
        }
        number
    }

    /// Whether there was a number for each.
    pub(super) fn fit(&self) -> bool {
        !self.left_out
    }

    /// The category: how many there are, and each with its length in front.
    pub(super) fn category(&self) -> Option<Category> {
        let length = |text: &Vec<u8>| u8::try_from(text.len()).unwrap_or(u8::MAX);
        let mut data = vec![u8::try_from(self.texts.len()).unwrap_or(u8::MAX)];
        for text in &self.texts {
            data.push(length(text));
            data.extend(text);
        }
        Category::of(STRINGS, data, 0)
    }
}

/// The text in the characters of a visible string, ISO 646; there is a question mark for any other.
fn visible(text: &str) -> Vec<u8> {
    let byte = |c: char| u8::try_from(c).ok().filter(|byte| (b' '..=b'~').contains(byte)).unwrap_or(b'?');
    text.split_whitespace().collect::<Vec<_>>().join(" ").chars().map(byte).collect()
}

#[cfg(test)]
mod tests {
    use super::Strings;

    #[test]
    fn equal_texts_share_a_number() {
        let mut strings = Strings::default();
        let numbers = ["Position", "", "Velocity", "Position"].map(|text| strings.number(text));
        assert_eq!(numbers, [1, 0, 2, 1]);
        let data = strings.category().unwrap().data;
        assert_eq!(data, b"\x02\x08Position\x08Velocity\0");
    }

    #[test]
    fn there_are_255_at_most() {
        let mut strings = Strings::default();
        let numbers: Vec<u8> = (0..255).map(|text| strings.number(&text.to_string())).collect();
        assert_eq!(numbers, (1..=255).collect::<Vec<u8>>());
        assert!(strings.fit());
        assert_eq!((strings.number("254"), strings.number("255")), (255, 0));
        assert!(!strings.fit());
    }

    #[test]
    fn what_no_string_holds_is_not_cut() {
        let mut strings = Strings::default();
        assert_eq!(strings.number(&"a".repeat(256)), 0);
        assert_eq!(strings.number(&"a".repeat(255)), 1);
        assert_eq!((strings.number("µm\n/ s"), strings.number("?m / s")), (2, 2));
    }
}
