//! The bounds of the values that have any and can be written.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal::{number, parsed};
use super::scope::Scope;
use super::stored::Stored;
use crate::model::{DataType, Entry, Value};

/// The constant of the dictionary that names the table, and the table; nothing if no value has bounds.
pub(super) fn items(scope: &Scope<'_>, stored: &[Stored<'_>]) -> (TokenStream, TokenStream) {
    let rows: Vec<TokenStream> = stored.iter().flat_map(rows).collect();
    if rows.is_empty() {
        return (TokenStream::new(), TokenStream::new());
    }
    let runtime = scope.runtime;
    let table = quote! {
        static RANGES: &[sdo::Range] = &[#(#rows),*];

        const fn range(field: u16, item: u8, axis: u8, limits: Limits) -> sdo::Range {
            sdo::Range { place: sdo::Place { field, item, axis }, limits }
        }
    };
    let table = quote! {
        use #runtime::sdo::Limits;
        #table
    };
    (
        quote!(
            const RANGES: &'static [sdo::Range] = RANGES;
        ),
        table,
    )
}

/// A row for all axes where they agree, else one for each that has bounds.
fn rows(stored: &Stored<'_>) -> Vec<TokenStream> {
    let mut rows = Vec::new();
    let field = number(stored.number);
    for (first, item) in stored.entries.iter().zip(0_usize..).filter(|(entry, _)| entry.access.writable()) {
        let item = number(item);
        let of_axes: Vec<Option<TokenStream>> =
            stored.placed.all.iter().map(|object| limits(object.entry(first.address.subindex)?)).collect();
        let text = |limits: &Option<TokenStream>| limits.as_ref().map(ToString::to_string);
        let agree = of_axes.iter().all(|limits| Some(text(limits)) == of_axes.first().map(text));
        if agree {
            let all = of_axes.into_iter().next().flatten();
            rows.extend(all.map(|limits| quote!(range(#field, #item, sdo::Range::EVERY_AXIS, #limits))));
            continue;
        }
        for (limits, axis) in of_axes.into_iter().zip(0_usize..) {
            let axis = number(axis);
            rows.extend(limits.map(|limits| quote!(range(#field, #item, #axis, #limits))));
        }
    }
    rows
}

/// The bounds of an entry; where one is missing, the type's own. A type of a few bits always has some, as it comes in a
/// byte.
fn limits(entry: &Entry) -> Option<TokenStream> {
    let (min, max) = (entry.min.as_ref(), entry.max.as_ref());
    let is_part = matches!(entry.data_type, DataType::Bits(2..8));
    if min.is_none() && max.is_none() && !is_part {
        return None;
    }
    let Some((least, greatest)) = entry.data_type.range() else { return real(entry) };
    let whole = |value: Option<&Value>, otherwise| value.and_then(Value::integer).unwrap_or(otherwise);
    let (min, max) = (number(whole(min, least)), number(whole(max, greatest)));
    Some(match entry.data_type {
        DataType::Int(_) => quote!(Limits::Signed(#min, #max)),
        _ => quote!(Limits::Unsigned(#min, #max)),
    })
}

fn real(entry: &Entry) -> Option<TokenStream> {
    if !matches!(entry.data_type, DataType::Real32 | DataType::Real64) {
        return None;
    }
    let literal = |value: &Value| match value {
        Value::Real(value) => Some(parsed(&format!("{value:?}"))),
        other => other.integer().map(|value| parsed(&format!("{value}.0"))),
    };
    let min = entry.min.as_ref().and_then(literal).unwrap_or_else(|| quote!(f64::NEG_INFINITY));
    let max = entry.max.as_ref().and_then(literal).unwrap_or_else(|| quote!(f64::INFINITY));
    Some(quote!(Limits::Real(#min, #max)))
}
