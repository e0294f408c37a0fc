//! The defaults of entries as a person would write them.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::literal::{hex8, hex16, hex32, number, parsed};
use super::types::Primitive;
use crate::model::{DataType, Entry, Value};

/// The default of an entry, as people write it; nothing stands for 0.
pub(super) fn value(entry: &Entry) -> TokenStream {
    default(entry, Primitive::of(entry.data_type))
}

/// The default of an entry that is kept as this primitive.
pub(super) fn kept(entry: &Entry, primitive: Primitive) -> TokenStream {
    primitive.constant(default(entry, primitive))
}

fn default(entry: &Entry, primitive: Primitive) -> TokenStream {
    let data_type = entry.data_type;
    match (primitive, entry.default.as_ref()) {
        (Primitive::Bool, value) => {
            let set = value.and_then(Value::integer).is_some_and(|value| value != 0);
            quote!(#set)
        }
        (Primitive::Text, Some(Value::Text(text))) => quote!(#text),
        (Primitive::Text, _) => quote!(""),
        (Primitive::Bytes(length), value) => bytes(value, data_type, length),
        (Primitive::Real(_), Some(Value::Real(value))) => parsed(&format!("{value:?}")),
        (Primitive::Real(_), value) => parsed(&format!("{}.0", whole(value))),
        (Primitive::Unsigned(bits), value) if entry.unit.is_none() => {
            unsigned(whole(value), bits).into_token_stream()
        }
        (Primitive::Unsigned(_) | Primitive::Signed(_), value) => number(whole(value)).into_token_stream(),
    }
}

fn whole(value: Option<&Value>) -> i128 {
    value.and_then(Value::integer).unwrap_or(0)
}

/// Large numbers without a sign and without a unit are mostly made of parts, so they are shown in hex.
fn unsigned(value: i128, bits: u8) -> Literal {
    match (u16::try_from(value), u32::try_from(value), bits) {
        (Ok(value), _, 16 | 32) if value > 0xFF => hex16(value),
        (Err(_), Ok(value), 32) => hex32(value),
        _ => number(value),
    }
}

fn bytes(value: Option<&Value>, data_type: DataType, length: u32) -> TokenStream {
    let bytes = value.map(|value| value.little_endian(data_type)).unwrap_or_default();
    if bytes.iter().all(|byte| *byte == 0) {
        let length = number(length);
        return quote!([0; #length]);
    }
    let bytes = bytes.iter().map(|byte| hex8(*byte));
    quote!([#(#bytes),*])
}
