//! Rust without std: constants, typed structs and tables over the runtime crate.
//!
//! [`tokens`] is the one back end of the derive, of build scripts and of the command line; [`text`] lays the
//! same tokens out for people. One file for each concern; each function makes one item.

mod axes;
mod braces;
mod bytes;
mod chosen;
mod codes;
mod commands;
mod contents;
mod default;
mod departures;
mod dictionary;
mod doc;
mod entry;
mod errors;
mod family;
mod free;
mod head;
mod homing;
mod images;
mod information;
mod item;
mod literal;
mod machine;
mod measure;
mod measured;
mod modes;
mod names;
mod objects;
mod packing;
mod page;
mod pdos;
mod ranges;
mod rows;
mod scope;
mod sharing;
mod slots;
mod space;
mod start_up;
mod states;
mod stored;
mod sync_managers;
mod table;
#[cfg(feature = "rust")]
mod text;
mod types;
mod units;
mod words;

use std::slice;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

#[cfg(feature = "derive")]
pub(crate) use head::identity;
pub use names::{camel, snake};
#[cfg(feature = "rust")]
pub use text::{Rust, module, text};

#[cfg(any(feature = "rust", feature = "derive"))]
use crate::diagnostic::Rule;
use crate::lint::Checked;
#[cfg(any(feature = "rust", feature = "derive"))]
use crate::lint::rules;
use crate::model::{Device, Family};
use item::{Holders, Space};
use scope::Scope;

/// What Rust cannot hold.
#[cfg(any(feature = "rust", feature = "derive"))]
pub(crate) const LINTS: &[&Rule] = &[
    &rules::clashing_identifier::RULE,
    &rules::empty_name::RULE,
    &rules::foreign_state::RULE,
    &rules::overlong_mode_code::RULE,
    &rules::several_edges::RULE,
];

/// What generated code depends on its surroundings for.
#[derive(Debug, Clone)]
pub struct Options {
    /// The path of the runtime crate.
    pub runtime: TokenStream,
    /// The type that stands for the device, declared beside the module; none to declare one in it.
    pub device: Option<Ident>,
    /// Whether there is the dictionary for a firmware; a master needs none.
    pub dictionary: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { runtime: quote!(::devc_runtime), device: None, dictionary: true }
    }
}

/// The content of a module: of one device alone, or of a family with a module for each member.
pub fn tokens(family: &Checked<Family>, options: &Options) -> TokenStream {
    match family.members.as_slice() {
        [device] => member(device, options),
        _ => family::tokens(family, options),
    }
}

/// The content of the module of a device that is alone.
pub fn member(device: &Device, options: &Options) -> TokenStream {
    let scope = Scope::new(device, None, options);
    let holders = Holders::alone();
    let of_spaces = contents::of(&scope, options).into_iter().map(|(space, items)| {
        let items = items.iter().map(|item| item.tokens(&holders));
        match space {
            Space::Root => items.collect(),
            space => space.module(scope.runtime, items),
        }
    });
    let parts = [head::module_doc(device).inner(), head::allowed(), head::imports(slice::from_ref(&scope))];
    let device = [head::device(&scope), start_up::family(&scope)];
    parts.into_iter().chain(device).chain(of_spaces).collect()
}
