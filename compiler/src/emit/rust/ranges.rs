//! The bounds of the values that have any and can be written.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal::{number, parsed};
use super::scope::Scope;
use super::stored::Stored;
use crate::model::Bounds;

/// The function of the dictionary that gives the table, and the table; nothing if no value has bounds.
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
            #[inline]
            fn ranges(&self) -> &'static [sdo::Range] {
                RANGES
            }
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
        let of_axes: Vec<Option<Bounds>> =
            stored.placed.all.iter().map(|object| object.entry(first.address.subindex)?.bounds()).collect();
        if of_axes.iter().all(|limits| Some(limits) == of_axes.first()) {
            let all = of_axes.first().and_then(Option::as_ref).map(tokens);
            rows.extend(all.map(|limits| quote!(range(#field, #item, sdo::Range::EVERY_AXIS, #limits))));
            continue;
        }
        for (limits, axis) in of_axes.iter().zip(0_usize..) {
            let (limits, axis) = (limits.as_ref().map(tokens), number(axis));
            rows.extend(limits.map(|limits| quote!(range(#field, #item, #axis, #limits))));
        }
    }
    rows
}

fn tokens(bounds: &Bounds) -> TokenStream {
    match *bounds {
        Bounds::Signed(min, max) => {
            let (min, max) = (number(min), number(max));
            quote!(Limits::Signed(#min, #max))
        }
        Bounds::Unsigned(min, max) => {
            let (min, max) = (number(min), number(max));
            quote!(Limits::Unsigned(#min, #max))
        }
        Bounds::Real(min, max) => {
            let (min, max) = (real(min), real(max));
            quote!(Limits::Real(#min, #max))
        }
    }
}

fn real(bound: f64) -> TokenStream {
    match bound {
        f64::NEG_INFINITY => quote!(f64::NEG_INFINITY),
        f64::INFINITY => quote!(f64::INFINITY),
        bound => parsed(&format!("{bound:?}")),
    }
}
