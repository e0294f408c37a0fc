//! Texts that hold for a range of subindices.

use crate::model::{DataType, Literal, Translation, Translations};
use crate::source::keys;

/// The text for one subindex: `{}` in it is the subindex, `{+8}` and `{-1}` are the subindex with a number added or
/// taken away, and `{-1:02}` is that with two digits at least. None if a brace holds anything else, or nothing closes it.
pub(super) fn numbered(text: &str, subindex: u8) -> Option<String> {
    let (mut out, mut rest) = (String::with_capacity(text.len() + 4), text);
    rest.contains('{').then_some(())?;
    while let Some((before, braced)) = rest.split_once('{') {
        let (inner, after) = braced.split_once('}')?;
        let (offset, width) = match inner.split_once(":0") {
            Some((offset, width)) => (offset, width.parse().ok().filter(|width| *width < 10)?),
            None => (inner, 0_usize),
        };
        let number = i64::from(subindex).checked_add(self::offset(offset)?)?;
        out.push_str(before);
        out.push_str(&format!("{number:0width$}"));
        rest = after;
    }
    out.push_str(rest);
    Some(out)
}

/// What is added to the subindex.
fn offset(text: &str) -> Option<i64> {
    match text.strip_prefix(['+', '-']) {
        _ if text.is_empty() => Some(0),
        Some(number) => {
            let number = keys::number(number).filter(|number| *number >= 0)?;
            if text.starts_with('-') { number.checked_neg() } else { Some(number) }
        }
        None => None,
    }
}

/// The text for one of several subindices; as it stands where it has no braces that make sense.
pub(super) fn of(text: &str, subindex: u8) -> String {
    numbered(text, subindex).unwrap_or_else(|| text.to_owned())
}

/// The name of one of several entries: numbered by its braces, or behind it.
pub(super) fn name(name: &str, subindex: u8) -> String {
    if name.contains('{') { of(name, subindex) } else { format!("{name} {subindex}") }
}

/// The names of one of several entries in other languages.
pub(super) fn names(names: &Translations, subindex: u8) -> Translations {
    let numbered = |it: &Translation| Translation { text: name(&it.text, subindex), ..it.clone() };
    Translations(names.iter().map(numbered).collect())
}

/// The value for one of several subindices: what counts with them is a number, or a text where values are texts.
pub(super) fn value(literal: &Literal, subindex: u8, data_type: DataType) -> Literal {
    let counted = match literal {
        Literal::Text(text) => numbered(text, subindex),
        _ => None,
    };
    match counted {
        None => literal.clone(),
        Some(text) if matches!(data_type, DataType::Text(_) | DataType::Unicode(_)) => Literal::Text(text),
        Some(text) => match text.parse() {
            Ok(number) => Literal::Integer(number),
            Err(_) => literal.clone(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::{numbered, value};
    use crate::model::{DataType, Literal};

    #[test]
    fn braces_are_numbers() {
        assert_eq!(numbered("DPRVAR{}", 3).as_deref(), Some("DPRVAR3"));
        assert_eq!(numbered("A619[{-1}]", 20).as_deref(), Some("A619[19]"));
        assert_eq!(numbered("{} of {+8} ({+8})", 1).as_deref(), Some("1 of 9 (9)"));
        assert_eq!(numbered("H02-{-1:02}", 6).as_deref(), Some("H02-05"));
        assert_eq!(numbered("H02-{-1:02}", 42).as_deref(), Some("H02-41"));
        assert_eq!(numbered("{+0x300}", 31).as_deref(), Some("799"));
    }

    #[test]
    fn other_braces_are_not() {
        for text in ["DPRVAR", "a {b}", "{+}", "{8}", "{", "{} and {x}", "{+--1}", "{:2}", "{:0x}", "{:099}"]
        {
            assert_eq!(numbered(text, 1), None, "{text}");
        }
    }

    #[test]
    fn a_value_counts_in_its_type() {
        let text = |text: &str| Literal::Text(text.to_owned());
        assert_eq!(value(&text("{+0x300}"), 2, DataType::Uint(16)), Literal::Integer(0x302));
        assert_eq!(value(&text("axis {}"), 2, DataType::Text(8)), text("axis 2"));
        assert_eq!(value(&text("axis {}"), 2, DataType::Uint(16)), text("axis {}"));
        assert_eq!(value(&Literal::Integer(7), 2, DataType::Uint(16)), Literal::Integer(7));
    }
}
