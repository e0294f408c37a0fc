//! The process images of configurations: their PDOs as they are mapped then, and all that are assigned then.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::axes::{self, Placed};
use super::doc::{Doc, sentence};
use super::images::{self, Image};
use super::item::{Holders, Item, Space};
use super::names::snake;
use super::pdos::{self, By};
use super::scope::Scope;
use crate::model::{Configuration, Direction, Index, Pdo, Role};

/// A module with the types of a configuration; none if its process data is that of the device by default.
pub(super) fn item<'s>(scope: &'s Scope<'_>, configuration: &'s Configuration) -> Option<Item<'s>> {
    let is_chosen = WAYS.into_iter().any(|way| is_chosen(scope, configuration, way));
    let name = snake(&configuration.id);
    let item = Item::held(name.clone(), move |holders| {
        (doc(configuration), module(scope, configuration, &name, holders))
    });
    let item = item.of(configuration).told(scope.device.axes.len());
    let remapped = axes::placed(&configuration.mapping, scope.device);
    let item = item.each(&remapped, |item, pdo| pdos::made_of(scope, pdo, item));
    let item = item.each(WAYS, |item, way| match self::is_chosen(scope, configuration, way) {
        true => item.each(assigned_by_default(scope, configuration, &remapped, way), |item, pdo| {
            scope.placed(item.using(Space::Root, &scope.pdo_ident(pdo)), pdo.shift)
        }),
        false => {
            item.each(images::by_default(scope, way), |item, _| item.using(Space::Root, &images::name(way)))
        }
    });
    is_chosen.then_some(item)
}

/// The PDOs of an image that are mapped as the device has them.
fn assigned_by_default<'s>(
    scope: &'s Scope<'_>,
    configuration: &Configuration,
    remapped: &[Placed<'_, Pdo>],
    way: Direction,
) -> Vec<&'s Placed<'s, Pdo>> {
    let has = |placed: &Placed<'_, Pdo>, index: Index| placed.all.iter().any(|pdo| pdo.index == index);
    let indices = assigned(scope, configuration, way).unwrap_or_default().iter();
    let indices = indices.filter(|index| !remapped.iter().any(|pdo| has(pdo, **index)));
    indices.filter_map(|index| scope.pdos.iter().find(|pdo| has(pdo, *index))).collect()
}

/// The PDOs that are assigned then.
fn assigned<'c>(
    scope: &'c Scope<'_>,
    configuration: &'c Configuration,
    way: Direction,
) -> Option<&'c [Index]> {
    let manager = scope.device.sync_manager(Role::of(way));
    configuration.assigned(way).or_else(|| manager.map(|manager| manager.pdos.as_slice()))
}

const WAYS: [Direction; 2] = [Direction::Rx, Direction::Tx];

fn doc(configuration: &Configuration) -> Doc {
    let name = sentence(&configuration.name);
    Doc::new(format!("Process data of the choice \u{201C}{}\u{201D}.", name.trim_end_matches('.')))
}

fn module(
    scope: &Scope<'_>,
    configuration: &Configuration,
    name: &Ident,
    holders: &Holders<'_>,
) -> TokenStream {
    let remapped = axes::placed(&configuration.mapping, scope.device);
    let pdos = remapped.iter().map(|pdo| {
        let (doc, code) = pdos::code(scope, pdo, By::Master, holders);
        quote!(#doc #code)
    });
    let images = WAYS.into_iter().filter_map(|way| match is_chosen(scope, configuration, way) {
        true => image(scope, configuration, &remapped, way),
        false => as_by_default(scope, way),
    });
    quote! {
        pub mod #name {
            use super::*;
            #(#pdos)*
            #(#images)*
        }
    }
}

/// Whether the configuration has other process data in this direction than the device by default.
fn is_chosen(scope: &Scope<'_>, configuration: &Configuration, way: Direction) -> bool {
    let by_default = scope.device.sync_manager(Role::of(way)).map(|manager| manager.pdos.as_slice());
    let is_assigned = configuration.assigned(way).is_some_and(|assigned| Some(assigned) != by_default);
    is_assigned || configuration.mapping.iter().any(|pdo| pdo.direction == way)
}

fn image(
    scope: &Scope<'_>,
    configuration: &Configuration,
    remapped: &[Placed<'_, Pdo>],
    way: Direction,
) -> Option<TokenStream> {
    let assigned = assigned(scope, configuration, way)?;
    let pdos: Vec<&Placed<'_, Pdo>> = remapped.iter().chain(&scope.pdos).collect();
    let doc = Doc::new(match way {
        Direction::Rx => "What the master sends then.",
        Direction::Tx => "What the device sends then.",
    });
    let image = Image::of(&pdos, assigned, way)?.code(scope);
    Some(quote!(#doc #image))
}

/// The image of the device by default, if it has a type.
fn as_by_default(scope: &Scope<'_>, way: Direction) -> Option<TokenStream> {
    let name = images::name(way);
    images::by_default(scope, way).map(|_| {
        quote! {
            /// As by default.
            pub type #name = super::super::#name;
        }
    })
}
