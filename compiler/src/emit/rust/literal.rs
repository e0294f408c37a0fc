//! Numbers and texts as a person would write them.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use crate::emit::escape::escape;

/// Tokens that are known to be fine.
pub(super) fn parsed(text: &str) -> TokenStream {
    text.parse().unwrap_or_default()
}

/// A text as one line.
pub(super) fn line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A text; [`Literal::string`] makes the same of it, but asks of each character whether it can be shown.
pub(super) fn text(text: &str) -> Literal {
    let mut code = String::with_capacity(text.len() + 16);
    code.push('"');
    escape(text, |_, byte| matches!(byte, b'"' | b'\\'), &mut code);
    code.push('"');
    code.parse().unwrap_or_else(|_| Literal::string(text))
}

/// Code that is known to be one literal.
fn literal(code: &str) -> Literal {
    code.parse().unwrap_or_else(|_| Literal::string(code))
}

/// An index, a mask or another number of 16 bits: `0x6040`.
pub(super) fn hex16(value: u16) -> Literal {
    literal(&format!("0x{value:04X}"))
}

/// A distance between indices: `0x800`.
pub(super) fn distance(value: u16) -> Literal {
    literal(&format!("0x{value:X}"))
}

/// A number of 8 bits: `0x81`.
pub(super) fn hex8(value: u8) -> Literal {
    literal(&format!("0x{value:02X}"))
}

/// A number of 32 bits: `0x0000_076D`.
pub(super) fn hex32(value: u32) -> Literal {
    literal(&format!("0x{:04X}_{:04X}", value >> 16, value & 0xFFFF))
}

/// A number without its type; none that is counted here is too large.
pub(super) fn number(value: impl TryInto<i128>) -> Literal {
    Literal::i128_unsuffixed(value.try_into().unwrap_or(i128::MAX))
}

/// A value that may be missing.
pub(super) fn option(value: Option<impl ToTokens>) -> TokenStream {
    match value {
        Some(value) => quote!(Some(#value)),
        None => quote!(None),
    }
}

/// A number with its thousands apart: `100_000`.
pub(super) fn grouped(value: u64) -> Literal {
    let digits = value.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('_');
        }
        text.push(digit);
    }
    literal(&text)
}
