//! The commands of the controlword.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::doc::{Doc, sentence};
use super::literal::{hex16, number};
use super::names::{Names, shout};
use super::scope::Scope;
use crate::model::{Command, Pattern};

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    let given: Vec<(&Command, &Pattern)> = scope
        .device
        .commands
        .iter()
        .filter_map(|command| Some((command, command.pattern.as_ref()?)))
        .collect();
    if given.is_empty() {
        return TokenStream::new();
    }
    let mut names = Names::with(&["ALL"]);
    let names: Vec<Ident> = given.iter().map(|(command, _)| names.claim(&shout(&command.id))).collect();
    let commands =
        given.iter().zip(&names).map(|((command, pattern), name)| constant(scope, command, pattern, name));
    quote! {
        /// The commands of the controlword.
        pub mod commands {
            use super::*;
            #(#commands)*

            /// Every command.
            pub const ALL: &[Command] = &[#(#names),*];
        }
    }
}

fn constant(scope: &Scope<'_>, command: &Command, pattern: &Pattern, name: &Ident) -> TokenStream {
    let doc = Doc::new(format!("{} `{pattern}`", sentence(&command.name)))
        .maybe(command.about.as_deref())
        .source(command.source.as_ref(), scope.device);
    let text = command.name.to_lowercase();
    let (mask, value) = (hex16(pattern.mask()), hex16(pattern.value()));
    let edge = match (pattern.rising(), pattern.falling()) {
        (0, 0) => quote!(None),
        (0, falling) => {
            let falling = hex16(falling);
            quote!(Some(Edge::Falling(#falling)))
        }
        (rising, _) => {
            let rising = hex16(rising);
            quote!(Some(Edge::Rising(#rising)))
        }
    };
    let supported = |number: &&u8| {
        !scope.device.transitions.iter().any(|known| known.number == **number && !known.supported)
    };
    let transitions = command.transitions.iter().filter(supported).map(number);
    quote! {
        #doc
        pub const #name: Command = Command {
            name: #text,
            pattern: Pattern { mask: #mask, value: #value },
            edge: #edge,
            transitions: &[#(#transitions),*],
        };
    }
}
