//! A typed constant for each entry.

use std::iter;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::axes::Placed;
use super::braces::braces;
use super::departures::Departures;
use super::doc::Doc;
use super::entry;
use super::item::{Item, Space};
use super::literal::{distance, hex16, number};
use super::names::{Names, shout, snake};
use super::scope::Scope;
use super::units;
use crate::model::{Access, Entry, Kind, Mappable, Object};

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let mut names = Names::with(&["units"]);
    scope.objects.iter().map(|placed| object(scope, placed, &mut names)).collect()
}

fn object<'s>(scope: &'s Scope<'_>, placed: &'s Placed<'_, Object>, names: &mut Names) -> Item<'s> {
    let object = placed.first;
    let item = match (object.entries.as_slice(), object.kind) {
        ([only], Kind::Var) => {
            let name = names.claim(&constant_name(placed, &placed.id));
            Item::new(name.clone(), move || constant(scope, placed, only, &name, None))
        }
        _ => {
            let name = names.claim(&snake(&placed.id));
            Item::new(name.clone(), move || {
                let departures = Departures::of(object);
                let doc = entry::object_doc(scope, object, &departures);
                (doc, module(scope, placed, &name, &departures))
            })
        }
    };
    let item = item.each(&placed.all, |item, object| item.of(*object));
    let item = item.each(&object.entries, |item, entry| {
        let newtype = scope.types.at(Some(entry.address), entry.data_type).newtype;
        let item = item.each(&newtype, |item, name| item.using(Space::Root, name));
        units::named(scope, entry, item)
    });
    scope.placed(item, placed.shift)
}

/// The module of an object with several entries.
fn module(
    scope: &Scope<'_>,
    placed: &Placed<'_, Object>,
    name: &Ident,
    departures: &Departures,
) -> TokenStream {
    let mut names = Names::default();
    let constants = placed.first.entries.iter().map(|entry| {
        let name = names.claim(&constant_name(placed, &entry.id));
        let (doc, code) = constant(scope, placed, entry, &name, Some(departures));
        quote!(#doc #code)
    });
    let imports = quote!(
        use super::*;
    );
    let content = braces(iter::once(imports).chain(constants));
    quote!(pub mod #name #content)
}

/// A function of the axis is named as functions are.
fn constant_name(placed: &Placed<'_, Object>, id: &str) -> Ident {
    if placed.shift.is_some() { snake(id) } else { shout(id) }
}

fn constant(
    scope: &Scope<'_>,
    placed: &Placed<'_, Object>,
    entry: &Entry,
    name: &Ident,
    departures: Option<&Departures>,
) -> (Doc, TokenStream) {
    let doc = entry::doc(scope, placed, entry, departures);
    let (index, subindex) = (hex16(entry.address.index.0), number(entry.address.subindex));
    let (measurand, unit) = units::of_entry(scope, placed, entry).unzip();
    let ty = entry_type(scope, entry, measurand);
    let measured = unit.map(|unit| quote!(.measured_in(#unit)));
    let code = match placed.shift.map(distance) {
        Some(shift) => quote! {
            pub const fn #name(axis: Axis) -> #ty {
                axis.entry(#index, #shift, #subindex)#measured
            }
        },
        None => quote! {
            pub const #name: #ty = Entry::new(#index, #subindex)#measured;
        },
    };
    (doc, code)
}

/// Device, type, access, direction and what is measured; the last two are left out where there is nothing to say.
fn entry_type(scope: &Scope<'_>, entry: &Entry, measurand: Option<TokenStream>) -> TokenStream {
    let (owner, value) = (&scope.owner, scope.types.at(Some(entry.address), entry.data_type).tokens());
    let access = match entry.access {
        Access::Ro => quote!(ReadOnly),
        Access::Wo => quote!(WriteOnly),
        Access::Rw => quote!(ReadWrite),
        Access::Const => quote!(Constant),
    };
    let mapping = mapping(entry).or(measurand.is_some().then(|| quote!(Unmapped)));
    let others = mapping.into_iter().chain(measurand);
    quote!(Entry<#owner, #value, #access #(, #others)*>)
}

/// The direction of the PDOs that the entry can be in.
fn mapping(entry: &Entry) -> Option<TokenStream> {
    match entry.pdo {
        Mappable::None => None,
        Mappable::Rx => Some(quote!(Rx)),
        Mappable::Tx => Some(quote!(Tx)),
        Mappable::RxTx => Some(quote!(RxTx)),
    }
}
