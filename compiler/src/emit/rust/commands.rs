//! The commands of the controlword.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::doc::{Doc, sentence};
use super::item::Item;
use super::literal::{hex16, number};
use super::names::{Names, shout};
use super::scope::Scope;
use super::states;
use crate::model::{Device, Given, Pattern};

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Option<Item<'s>> {
    let device = scope.device;
    device.given().next()?;
    let item =
        Item::new(format_ident!("commands"), || (Doc::new("The commands of the controlword."), code(device)));
    Some(item.of(&device.commands).of(&device.transitions))
}

fn code(device: &Device) -> TokenStream {
    let given: Vec<Given<'_>> = device.given().collect();
    let mut names = Names::with(&["ALL"]);
    let names: Vec<Ident> = given.iter().map(|command| names.claim(&shout(&id(*command)))).collect();
    let commands = given.iter().zip(&names).map(|(command, name)| constant(device, *command, name));
    quote! {
        pub mod commands {
            use super::*;
            #(#commands)*

            /// Every command.
            pub const ALL: &[Command] = &[#(#names),*];
        }
    }
}

/// Every command; the list of them, for what refers to it.
pub(super) fn list(device: &Device) -> TokenStream {
    if device.given().next().is_none() { quote!(&[]) } else { quote!(commands::ALL) }
}

/// The word for it.
fn id(given: Given<'_>) -> String {
    match given {
        Given::Command(command, _) => command.id.clone(),
        Given::Transition(one, _) => {
            format!("{}-{}", one.command.as_deref().unwrap_or("Transition"), one.number)
        }
    }
}

fn doc(device: &Device, given: Given<'_>) -> Doc {
    let pattern = given.pattern();
    match given {
        Given::Command(command, _) => Doc::new(format!("{} `{pattern}`", sentence(&command.name)))
            .maybe(command.about.as_deref())
            .said(command.source.as_ref(), &command.origin, device),
        Given::Transition(one, _) => {
            let name = one.command.as_deref().unwrap_or("Transition");
            let title = sentence(&format!("{name}, transition {}", one.number));
            Doc::new(format!("{title} `{pattern}`")).maybe(one.about.as_deref()).said(
                one.source.as_ref(),
                &one.origin,
                device,
            )
        }
    }
}

fn constant(device: &Device, given: Given<'_>, name: &Ident) -> TokenStream {
    let (doc, text, pattern) = (doc(device, given), given.name(), given.pattern());
    let (mask, value, edge) = (hex16(pattern.mask()), hex16(pattern.value()), edge(pattern));
    let (transitions, ignored_in) = (device.set_off(given).into_iter().map(number), set(given.ignored_in()));
    quote! {
        #doc
        pub const #name: Command =
            Command::new(#text, #mask, #value, &[#(#transitions),*]) #edge #ignored_in;
    }
}

/// A set of states, by their ids.
fn set(ids: &[String]) -> Option<TokenStream> {
    let mut states = ids.iter().filter_map(|id| states::state(id)).peekable();
    states.peek().is_some().then(|| quote!(.ignored_in(StateSet::of(&[#(State::#states),*]))))
}

fn edge(pattern: &Pattern) -> Option<TokenStream> {
    match (pattern.rising(), pattern.falling()) {
        (0, 0) => None,
        (0, falling) => {
            let falling = hex16(falling);
            Some(quote!(.on(Edge::Falling(#falling))))
        }
        (rising, _) => {
            let rising = hex16(rising);
            Some(quote!(.on(Edge::Rising(#rising))))
        }
    }
}
