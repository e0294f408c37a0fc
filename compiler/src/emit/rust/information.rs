//! The names of objects and entries, for the SDO information services.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::page::Page;
use crate::model::{Kind, Object};

/// The table of names, by the pages of the table of entries. Pages of axes that are alike share their names.
pub(super) fn items(pages: &[Page<'_>]) -> TokenStream {
    let mut shared: Vec<(Vec<&str>, Ident)> = Vec::new();
    let (mut tables, mut rows) = (TokenStream::new(), Vec::new());
    for page in pages {
        let names: Vec<&str> = page.objects().flat_map(names).collect();
        let known = shared.iter().find(|(known, _)| *known == names).map(|(_, table)| table.clone());
        rows.push(known.unwrap_or_else(|| {
            let table = format_ident!("NAMES_{:02X}", page.high);
            tables.extend(quote!(const #table: &[&str] = &[#(#names),*];));
            shared.push((names, table.clone()));
            table
        }));
    }
    quote! {
        /// The name of every object and entry, for a firmware that tells what is in its dictionary.
        pub static NAMES: sdo::Names = sdo::Names { pages: &[#(#rows),*] };

        #tables
    }
}

/// The name of a single value, or of an object and then of its entries.
fn names(object: &Object) -> Vec<&str> {
    let entries = object.entries.iter().filter(|_| object.kind != Kind::Var);
    std::iter::once(object.name.as_str()).chain(entries.map(|entry| entry.name.as_str())).collect()
}
