//! The process images of configurations: their PDOs as they are mapped then, and all that are assigned then.

use proc_macro2::TokenStream;
use quote::quote;

use super::axes::{self, Placed};
use super::doc::{Doc, sentence};
use super::images;
use super::names::snake;
use super::pdos::{self, By};
use super::scope::Scope;
use crate::model::{Configuration, Direction, Pdo, Role};

/// A module with the types of a configuration; none if its process data is that of the device by default.
pub(super) fn module(scope: &Scope<'_>, configuration: &Configuration) -> Option<TokenStream> {
    let remapped = axes::placed(&configuration.mapping, scope.device);
    let is_chosen = |way| is_chosen(scope, configuration, way);
    if ![Direction::Rx, Direction::Tx].into_iter().any(is_chosen) {
        return None;
    }
    let name = snake(&configuration.id);
    let doc = Doc::new(format!(
        "Process data of the choice \u{201C}{}\u{201D}.",
        sentence(&configuration.name).trim_end_matches('.')
    ));
    let pdos = remapped.iter().map(|pdo| pdos::items_of(scope, pdo, By::Master));
    let images = [Direction::Rx, Direction::Tx].into_iter().filter_map(|way| match is_chosen(way) {
        true => image(scope, configuration, &remapped, way),
        false => as_by_default(scope, way),
    });
    Some(quote! {
        #doc
        pub mod #name {
            use super::*;
            #(#pdos)*
            #(#images)*
        }
    })
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
    let manager = scope.device.sync_manager(Role::of(way));
    let assigned = configuration.assigned(way).or_else(|| manager.map(|manager| manager.pdos.as_slice()))?;
    let pdos: Vec<&Placed<'_, Pdo>> = remapped.iter().chain(&scope.pdos).collect();
    let doc = Doc::new(match way {
        Direction::Rx => "What the master sends then.",
        Direction::Tx => "What the device sends then.",
    });
    images::image(scope, &pdos, assigned, way, &doc)
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
