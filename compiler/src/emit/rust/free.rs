//! PDOs whose mapping is free: a type for each, with its limits.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::axes::Placed;
use super::doc::Doc;
use super::item::{Holders, Item};
use super::literal::{hex16, number, option};
use super::scope::Scope;
use crate::model::Pdo;

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let free = scope.pdos.iter().filter(|pdo| !pdo.first.fixed);
    let items = free.map(|pdo| {
        let name = format_ident!("Free{}", scope.pdo_ident(pdo));
        let item = Item::held(name.clone(), move |holders| code(scope, pdo, &name, holders));
        item.each(&pdo.all, |item, pdo| item.of(*pdo))
    });
    items.collect()
}

fn code(
    scope: &Scope<'_>,
    placed: &Placed<'_, Pdo>,
    name: &Ident,
    holders: &Holders<'_>,
) -> (Doc, TokenStream) {
    let (pdo, owner, members) = (placed.first, &scope.owner, super::pdos::members(holders));
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
    let code = quote! {
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum #name {}

        impl MappingObject for #name {
            type Device = #owner;
            type Direction = #direction;
            const INDICES: &'static [u16] = &[#(#indices),*];
            const MAX_BYTES: Option<u16> = #max_bytes;
            const MAX_ENTRIES: Option<u8> = #max_entries;
            #members
        }
    };
    (doc, code)
}
