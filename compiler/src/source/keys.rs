//! Numbers and ranges as keys.

use std::ops::RangeInclusive;

/// A whole number in decimal or hexadecimal, with a sign or without.
pub(crate) fn number(text: &str) -> Option<i64> {
    let (negative, digits) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
    let value = match hexadecimal(digits) {
        Some(hex) if !hex.starts_with(['+', '-']) => i64::from_str_radix(hex, 16).ok()?,
        None if digits.starts_with(|c: char| c.is_ascii_digit()) => digits.parse().ok()?,
        _ => return None,
    };
    Some(if negative { -value } else { value })
}

/// The digits of a number without a sign that is written in hexadecimal.
pub(crate) fn hexadecimal(text: &str) -> Option<&str> {
    text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"))
}

/// A number, or a range of numbers such as `"4..=6"`.
pub(crate) fn range<T: TryFrom<i64> + PartialOrd + Copy>(text: &str) -> Option<RangeInclusive<T>> {
    // most keys are words, and most others are a single number
    if !text.trim_start().starts_with(|c: char| c == '-' || c.is_ascii_digit()) {
        return None;
    }
    let span = if text.contains('.') { text.split_once("..=") } else { None };
    let (first, last) = span.unwrap_or((text, text));
    let first = T::try_from(number(first.trim())?).ok()?;
    let last = T::try_from(number(last.trim())?).ok()?;
    (first <= last).then_some(first..=last)
}

/// Names as a person reads them, not all if they are many.
pub(crate) fn some(names: &[String]) -> String {
    const READ: usize = 20;
    let first: Vec<&str> = names.iter().take(READ).map(String::as_str).collect();
    let more = if names.len() > READ { " and others" } else { "" };
    first.join(", ") + more
}

/// The place of a name in a list, or of a range of names such as `"Y..=W"`.
pub(crate) fn names(text: &str, known: &[String]) -> Option<RangeInclusive<usize>> {
    let (first, last) = text.split_once("..=").unwrap_or((text, text));
    let place = |name: &str| known.iter().position(|known| known == name.trim());
    let (first, last) = (place(first)?, place(last)?);
    (first <= last).then_some(first..=last)
}
