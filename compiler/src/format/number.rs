//! How numbers and keys are written.

use crate::source::keys::{number, range};

/// A number in hexadecimal has upper-case digits; what is no such number stays as it is.
pub(super) fn value(written: &str) -> String {
    written
        .strip_prefix("0x")
        .map_or_else(|| written.to_owned(), |digits| format!("0x{}", digits.to_uppercase()))
}

/// A whole number as a code of 32 bits, as identities are printed.
pub(super) fn code(written: &str) -> String {
    let plain = written.replace('_', "");
    match number(&plain).and_then(|number| u32::try_from(number).ok()) {
        Some(code) => format!("0x{code:08X}"),
        None => value(written),
    }
}

/// A key, or a range of keys, with upper-case digits; `is_index` if its numbers have 16 bits.
pub(super) fn key(name: &str, is_index: bool) -> String {
    let part = |part: &str| match number(part) {
        Some(value) if is_index && (0..=0xFFFF).contains(&value) => format!("0x{value:04X}"),
        Some(_) => match part.strip_prefix("0x").or_else(|| part.strip_prefix("0X")) {
            Some(digits) => format!("0x{}", digits.to_uppercase()),
            None => part.to_owned(),
        },
        None => part.to_owned(),
    };
    match name.split_once("..=") {
        // names of axes are no numbers, and what begins behind its end is a word
        Some((first, last)) if range::<i64>(name).is_some() => {
            format!("{}..={}", part(first.trim()), part(last.trim()))
        }
        Some(_) => name.to_owned(),
        None => part(name),
    }
}

/// An index, with a subindex or a range of them behind it or not, as references are written; none if it is another word.
pub(super) fn reference(text: &str) -> Option<String> {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"))?;
    let (index, subindex) = digits.split_once(':').map_or((digits, None), |(index, sub)| (index, Some(sub)));
    let index = u16::from_str_radix(index, 16).ok().filter(|_| !index.starts_with('+'))?;
    let Some(subindex) = subindex else { return Some(format!("0x{index:04X}")) };
    let is_plain = subindex.chars().all(|c| c.is_ascii_hexdigit() || matches!(c, '.' | '='));
    is_plain.then(|| format!("0x{index:04X}:{}", subindex.to_uppercase()))
}

/// A key with quotes where it needs them; as it was written where they cannot be had without escapes.
pub(super) fn quoted(name: &str, written: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_');
    if !name.is_empty() && name.chars().all(is_bare) {
        return name.to_owned();
    }
    if name.chars().any(|c| c.is_control() || matches!(c, '"' | '\\')) {
        return written.to_owned();
    }
    format!("\"{name}\"")
}
