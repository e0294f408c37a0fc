//! The names of objects and entries, for the SDO information services.

use proc_macro2::Ident;
use quote::{format_ident, quote};

use super::doc::Doc;
use super::item::{Item, Reach};
use super::page::Page;
use super::scope::Scope;
use crate::model::{Kind, Object};

/// The table of names, by the pages of the table of entries. Pages of axes that are alike share their names.
pub(super) fn items<'s>(scope: &'s Scope<'_>, pages: &[Page<'s, '_>]) -> Vec<Item<'s>> {
    let mut shared: Vec<(Vec<&'s str>, Ident)> = Vec::new();
    let (mut items, mut rows) = (Vec::new(), Vec::new());
    for page in pages {
        let names: Vec<&'s str> = page.objects().flat_map(names).collect();
        let known = shared.iter().find(|(known, _)| *known == names).map(|(_, table)| table.clone());
        rows.push(known.unwrap_or_else(|| {
            let table = format_ident!("NAMES_{:02X}", page.high);
            items.push(item(scope, table.clone(), names.clone()));
            shared.push((names, table.clone()));
            table
        }));
    }
    let all = Item::new(format_ident!("NAMES"), move || {
        let doc = "The name of every object and entry, for a firmware that tells what is in its dictionary.";
        let doc =
            scope.device.mailbox.iter().fold(Doc::new(doc), |doc, mailbox| {
                doc.departing(&["sdo-info"], &mailbox.origin, scope.device)
            });
        (doc, quote!(pub static NAMES: sdo::Names = sdo::Names { pages: &[#(#rows),*] };))
    });
    [all.reaching(Reach::Own)].into_iter().chain(items).collect()
}

fn item<'s>(scope: &'s Scope<'_>, table: Ident, names: Vec<&'s str>) -> Item<'s> {
    let told = names.join("\n");
    let item = Item::new(table.clone(), move || {
        let within = &scope.within.0;
        (Doc::default(), quote!(#within const #table: &[&str] = &[#(#names),*];))
    });
    item.reaching(Reach::Family).told(told)
}

/// The name of a single value, or of an object and then of its entries.
fn names(object: &Object) -> Vec<&str> {
    let entries = object.entries.iter().filter(|_| object.kind != Kind::Var);
    std::iter::once(object.name.as_str()).chain(entries.map(|entry| entry.name.as_str())).collect()
}
