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
        let of_axes: Vec<Option<Limits>> = stored
            .placed
            .all
            .iter()
            .map(|object| Limits::of(object.entry(first.address.subindex)?))
            .collect();
        if of_axes.iter().all(|limits| Some(limits) == of_axes.first()) {
            let all = of_axes.first().and_then(Option::as_ref).map(Limits::tokens);
            rows.extend(all.map(|limits| quote!(range(#field, #item, sdo::Range::EVERY_AXIS, #limits))));
            continue;
        }
        for (limits, axis) in of_axes.iter().zip(0_usize..) {
            let (limits, axis) = (limits.as_ref().map(Limits::tokens), number(axis));
            rows.extend(limits.map(|limits| quote!(range(#field, #item, #axis, #limits))));
        }
    }
    rows
}

/// The bounds of an entry; of a whole number, where one is missing, the type's own. A type of a few bits always has
/// some, as it comes in a byte.
#[derive(PartialEq)]
enum Limits {
    Signed(i128, i128),
    Unsigned(i128, i128),
    Real(Option<Value>, Option<Value>),
}

impl Limits {
    fn of(entry: &Entry) -> Option<Self> {
        let (min, max) = (entry.min.as_ref(), entry.max.as_ref());
        let is_part = matches!(entry.data_type, DataType::Bits(2..8));
        if min.is_none() && max.is_none() && !is_part {
            return None;
        }
        let whole = |value: Option<&Value>, otherwise| value.and_then(Value::integer).unwrap_or(otherwise);
        match (entry.data_type, entry.data_type.range()) {
            (DataType::Int(_), Some((least, most))) => {
                Some(Self::Signed(whole(min, least), whole(max, most)))
            }
            (_, Some((least, most))) => Some(Self::Unsigned(whole(min, least), whole(max, most))),
            (DataType::Real32 | DataType::Real64, None) => Some(Self::Real(min.cloned(), max.cloned())),
            (_, None) => None,
        }
    }

    fn tokens(&self) -> TokenStream {
        let literal = |value: &Value| match value {
            Value::Real(value) => Some(parsed(&format!("{value:?}"))),
            other => other.integer().map(|value| parsed(&format!("{value}.0"))),
        };
        match self {
            Self::Signed(min, max) => {
                let (min, max) = (number(*min), number(*max));
                quote!(Limits::Signed(#min, #max))
            }
            Self::Unsigned(min, max) => {
                let (min, max) = (number(*min), number(*max));
                quote!(Limits::Unsigned(#min, #max))
            }
            Self::Real(min, max) => {
                let min = min.as_ref().and_then(literal).unwrap_or_else(|| quote!(f64::NEG_INFINITY));
                let max = max.as_ref().and_then(literal).unwrap_or_else(|| quote!(f64::INFINITY));
                quote!(Limits::Real(#min, #max))
            }
        }
    }
}
