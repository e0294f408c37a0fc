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
mod default;
mod dictionary;
mod doc;
mod entry;
mod errors;
mod free;
mod head;
mod homing;
mod images;
mod information;
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
mod slots;
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
use braces::braces;
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
}

impl Default for Options {
    fn default() -> Self {
        Self { runtime: quote!(::devc_runtime), device: None }
    }
}

/// The content of a module: of one device alone, or with a module for each member of a family.
pub fn tokens(family: &Checked<Family>, options: &Options) -> TokenStream {
    match family.members.as_slice() {
        [device] => member(device, options),
        members => {
            let modules = members.iter().map(|device| {
                let (name, content) = (snake(&device.id), braces([member(device, options)]));
                quote!(pub mod #name #content)
            });
            let title = doc::Doc::new(format!("The devices of the family {}.", doc::escape(&family.name)));
            let title = title.inner();
            let reason = "a family may bear the name of a member";
            quote!(#title #![allow(clippy::module_inception, reason = #reason)] #(#modules)*)
        }
    }
}

/// The content of a member's module.
pub fn member(device: &Device, options: &Options) -> TokenStream {
    let scope = Scope::new(device, options);
    let parts = [
        head::items(&scope),
        objects::module(&scope),
        words::items(&scope),
        codes::items(&scope),
        pdos::items(&scope),
        free::items(&scope),
        images::items(&scope),
        sync_managers::items(&scope),
        start_up::items(&scope),
        states::items(&scope),
        commands::items(&scope),
        modes::items(&scope),
        machine::items(&scope),
        homing::items(&scope),
        errors::items(&scope),
        units::module(&scope),
        dictionary::module(&scope),
    ];
    parts.into_iter().collect()
}
