//! PDOs whose mapping is free: a type for each, with its limits.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::axes::Placed;
use super::doc::Doc;
use super::literal::{hex16, number, option};
use super::scope::Scope;
use crate::model::Pdo;

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    scope.pdos.iter().filter(|pdo| !pdo.first.fixed).map(|pdo| item(scope, pdo)).collect()
}

fn item(scope: &Scope<'_>, placed: &Placed<'_, Pdo>) -> TokenStream {
    let pdo = placed.first;
    let (name, marker) = (format_ident!("Free{}", scope.pdo_ident(placed)), &scope.marker);
    let direction = super::pdos::direction(pdo.direction);
    let indices = placed.all.iter().map(|pdo| hex16(pdo.index.0));
    let (max_bytes, max_entries) = (option(pdo.max_bytes.map(number)), option(pdo.max_entries.map(number)));
    let limits: Vec<String> = [
        pdo.max_bytes.map(|bytes| format!("{bytes} bytes")),
        pdo.max_entries.map(|entries| format!("{entries} entries")),
    ]
    .into_iter()
    .flatten()
    .collect();
    let limits =
        if limits.is_empty() { String::new() } else { format!(" At most {}.", limits.join(" and ")) };
    let doc = Doc::new(format!("`{}`, to be mapped freely by `#[derive(Pdo)]`.{limits}", pdo.index)).said(
        pdo.source.as_ref(),
        &pdo.origin,
        scope.device,
    );
    quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum #name {}

        impl MappingObject for #name {
            type Device = #marker;
            type Direction = #direction;
            const INDICES: &'static [u16] = &[#(#indices),*];
            const MAX_BYTES: Option<u16> = #max_bytes;
            const MAX_ENTRIES: Option<u8> = #max_entries;
        }
    }
}
