//! A typed constant for each entry.

use std::iter;

use proc_macro2::{Group, Ident, TokenStream};
use quote::quote;

use super::axes::Placed;
use super::braces::braces;
use super::entry;
use super::literal::{distance, hex16, number};
use super::names::{Names, shout, snake};
use super::scope::Scope;
use super::units;
use crate::model::{Access, Entry, Kind, Mappable, Object};

pub(super) fn module(scope: &Scope<'_>) -> TokenStream {
    let mut names = Names::with(&["units"]);
    let content = content(scope.objects.iter().map(|placed| object(scope, placed, &mut names)));
    quote! {
        /// The entries of the object dictionary, as a master reads and writes them.
        pub mod objects #content
    }
}

fn object(scope: &Scope<'_>, placed: &Placed<'_, Object>, names: &mut Names) -> TokenStream {
    let object = placed.first;
    if let ([only], Kind::Var) = (object.entries.as_slice(), object.kind) {
        let name = names.claim(&constant_name(placed, &placed.id));
        return constant(scope, placed, only, &name);
    }
    let name = names.claim(&snake(&placed.id));
    let doc = entry::object_doc(scope, object);
    let mut names = Names::default();
    let constants = object.entries.iter().map(|entry| {
        let name = names.claim(&constant_name(placed, &entry.id));
        constant(scope, placed, entry, &name)
    });
    let content = content(constants);
    quote!(#doc pub mod #name #content)
}

/// What is in the braces of a module.
fn content(items: impl Iterator<Item = TokenStream>) -> Group {
    braces(
        iter::once(quote!(
            use super::*;
        ))
        .chain(items),
    )
}

/// A function of the axis is named as functions are.
fn constant_name(placed: &Placed<'_, Object>, id: &str) -> Ident {
    if placed.shift.is_some() { snake(id) } else { shout(id) }
}

fn constant(scope: &Scope<'_>, placed: &Placed<'_, Object>, entry: &Entry, name: &Ident) -> TokenStream {
    let doc = entry::doc(scope, placed, entry);
    let (index, subindex) = (hex16(entry.address.index.0), number(entry.address.subindex));
    let (measurand, unit) = units::of_entry(scope, placed, entry).unzip();
    let ty = entry_type(scope, entry, measurand);
    let measured = unit.map(|unit| quote!(.measured_in(#unit)));
    match placed.shift.map(distance) {
        Some(shift) => quote! {
            #doc
            pub const fn #name(axis: Axis) -> #ty {
                axis.entry(#index, #shift, #subindex)#measured
            }
        },
        None => quote! {
            #doc
            pub const #name: #ty = Entry::new(#index, #subindex)#measured;
        },
    }
}

/// Device, type, access, direction and what is measured; the last two are left out where there is nothing to say.
fn entry_type(scope: &Scope<'_>, entry: &Entry, measurand: Option<TokenStream>) -> TokenStream {
    let (marker, value) = (&scope.marker, scope.types.at(Some(entry.address), entry.data_type).tokens());
    let access = match entry.access {
        Access::Ro => quote!(ReadOnly),
        Access::Wo => quote!(WriteOnly),
        Access::Rw => quote!(ReadWrite),
        Access::Const => quote!(Constant),
    };
    let mapping = mapping(entry).or(measurand.is_some().then(|| quote!(Unmapped)));
    let others = mapping.into_iter().chain(measurand);
    quote!(Entry<#marker, #value, #access #(, #others)*>)
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
