//! Running text: escaped, with every index and every parameter in it linked, and what stands between backticks as it is typed.

use super::Context;
use crate::emit::markdown::inline::code;
use crate::model::{Address, Index};

impl Context<'_> {
    /// Text on one line.
    pub(in crate::emit::markdown) fn prose(&self, plain: &str) -> String {
        if !plain.contains('`') {
            return self.words(plain.trim());
        }
        let plain = plain.split_whitespace().collect::<Vec<_>>().join(" ");
        let (mut out, mut rest) = (String::with_capacity(plain.len()), &*plain);
        while let Some((before, typed, after)) = span(rest) {
            out += &self.words(before);
            out += &self.typed(typed);
            rest = after;
        }
        out + &self.words(rest)
    }

    /// Text on one line, if there is any.
    pub(in crate::emit::markdown) fn optional(&self, plain: Option<&str>) -> String {
        plain.map_or(String::new(), |plain| self.prose(plain))
    }

    /// Text in paragraphs, as blank lines divide it.
    pub(in crate::emit::markdown) fn paragraphs(&self, plain: Option<&str>) -> String {
        let paragraphs = plain.unwrap_or("").split("\n\n").map(|paragraph| self.prose(paragraph));
        paragraphs.collect::<Vec<_>>().join("\n\n")
    }

    /// What is to be typed; an index or a parameter alone is a link here, too.
    fn typed(&self, plain: &str) -> String {
        let number = plain.strip_prefix("0x").map(Number::read).filter(|number| number.rest.is_empty());
        number.map_or_else(|| self.parameter(plain), |number| self.number(&number))
    }

    fn words(&self, plain: &str) -> String {
        let mut out = String::with_capacity(plain.len() + plain.len() / 8);
        let mut rest = plain;
        // most texts have no number, which is asked more cheaply than where it is
        while rest.contains("0x")
            && let Some((before, after)) = rest.split_once("0x")
        {
            let number = Number::read(after);
            self.named_parameters(before, &mut out);
            out.push_str(&self.number(&number));
            rest = number.rest;
        }
        self.named_parameters(rest, &mut out);
        out
    }

    fn number(&self, number: &Number<'_>) -> String {
        let index = (number.digits.len() == 4).then(|| u16::from_str_radix(number.digits, 16).ok()).flatten();
        let subindex = number.subindex.and_then(|digits| u8::from_str_radix(digits, 16).ok());
        match (index.map(Index), subindex) {
            (Some(index), Some(subindex)) => self.linked(index, &code(Address { index, subindex })),
            (Some(index), None) => self.index(index),
            (None, _) if number.digits.is_empty() => "0x".into(),
            (None, _) => self.parameter(&format!("0x{}", number.digits)),
        }
    }
}

/// What follows `0x`.
struct Number<'a> {
    digits: &'a str,
    subindex: Option<&'a str>,
    rest: &'a str,
}

impl<'a> Number<'a> {
    fn read(text: &'a str) -> Self {
        let (digits, rest) = split_hex(text);
        let subindex = rest.strip_prefix(':').map(split_hex).filter(|(sub, _)| sub.len() == 2);
        match subindex {
            Some((subindex, rest)) => Self { digits, subindex: Some(subindex), rest },
            None => Self { digits, subindex: None, rest },
        }
    }
}

/// What stands between the first two backticks, with what is before and behind. Those beside others open and close nothing, and
/// would stand for other things in Markdown.
fn span(text: &str) -> Option<(&str, &str, &str)> {
    let is_tick = |place: Option<usize>| place.and_then(|place| text.as_bytes().get(place)) == Some(&b'`');
    let ticks = text.match_indices('`').map(|(place, _)| place);
    let mut alone = ticks.filter(|place| !is_tick(place.checked_sub(1)) && !is_tick(place.checked_add(1)));
    let (open, close) = (alone.next()?, alone.next()?);
    Some((text.get(..open)?, text.get(open + 1..close)?, text.get(close + 1..)?))
}

fn split_hex(text: &str) -> (&str, &str) {
    let end = text.find(|c: char| !c.is_ascii_hexdigit()).unwrap_or(text.len());
    text.split_at(end)
}
