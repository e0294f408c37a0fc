//! The commands of the controlword.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::doc::{Doc, sentence};
use super::literal::{hex16, number};
use super::names::{Names, shout};
use super::scope::Scope;
use super::states;
use crate::model::{Command, Device, Pattern, Transition};

/// What a controlword asks for, and of which transitions.
struct Given<'a> {
    /// The word for it.
    id: String,
    name: String,
    pattern: &'a Pattern,
    transitions: Vec<u8>,
    /// The states in which it does nothing.
    ignored_in: &'a [String],
    doc: Doc,
}

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    let given = given(scope.device);
    if given.is_empty() {
        return TokenStream::new();
    }
    let mut names = Names::with(&["ALL"]);
    let names: Vec<Ident> = given.iter().map(|command| names.claim(&shout(&command.id))).collect();
    let commands = given.iter().zip(&names).map(|(command, name)| constant(command, name));
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

/// Every command; the list of them, for what refers to it.
pub(super) fn list(device: &Device) -> TokenStream {
    if given(device).is_empty() { quote!(&[]) } else { quote!(commands::ALL) }
}

/// The commands, and a command for each transition that has bits of its own.
fn given(device: &Device) -> Vec<Given<'_>> {
    let commands = device.commands.iter().filter_map(|command| of_command(device, command));
    commands.chain(device.transitions.iter().filter_map(|one| of_transition(device, one))).collect()
}

fn of_command<'a>(device: &'a Device, command: &'a Command) -> Option<Given<'a>> {
    let pattern = command.pattern.as_ref()?;
    let doc = Doc::new(format!("{} `{pattern}`", sentence(&command.name)))
        .maybe(command.about.as_deref())
        .said(command.source.as_ref(), &command.origin, device);
    let is_made =
        |number: &&u8| !device.transitions.iter().any(|one| one.number == **number && !one.supported);
    Some(Given {
        id: command.id.clone(),
        name: command.name.to_lowercase(),
        pattern,
        transitions: command.transitions.iter().filter(is_made).copied().collect(),
        ignored_in: &command.ignored_in,
        doc,
    })
}

/// What makes a transition that follows bits of the controlword; one that is automatic does not wait for them.
fn of_transition<'a>(device: &'a Device, transition: &'a Transition) -> Option<Given<'a>> {
    let pattern = transition.pattern.as_ref().filter(|_| transition.supported && !transition.automatic)?;
    let number = transition.number;
    let name = transition.command.clone().unwrap_or_else(|| "Transition".into());
    let doc = Doc::new(format!("{} `{pattern}`", sentence(&format!("{name}, transition {number}"))))
        .maybe(transition.about.as_deref())
        .said(transition.source.as_ref(), &transition.origin, device);
    let id = format!("{name}-{number}");
    let name = match transition.command {
        Some(_) => name.to_lowercase(),
        None => format!("transition {number}"),
    };
    Some(Given { id, name, pattern, transitions: vec![number], ignored_in: &[], doc })
}

fn constant(command: &Given<'_>, name: &Ident) -> TokenStream {
    let Given { id: _, name: text, pattern, transitions, ignored_in, doc } = command;
    let (mask, value, edge) = (hex16(pattern.mask()), hex16(pattern.value()), edge(pattern));
    let (transitions, ignored_in) = (transitions.iter().copied().map(number), set(ignored_in));
    quote! {
        #doc
        pub const #name: Command = Command {
            name: #text,
            pattern: Pattern { mask: #mask, value: #value },
            edge: #edge,
            transitions: &[#(#transitions),*],
            ignored_in: #ignored_in,
        };
    }
}

/// A set of states, by their ids.
fn set(ids: &[String]) -> TokenStream {
    let mut states = ids.iter().filter_map(|id| states::state(id)).peekable();
    match states.peek() {
        None => quote!(StateSet::NONE),
        Some(_) => quote!(StateSet::of(&[#(State::#states),*])),
    }
}

fn edge(pattern: &Pattern) -> TokenStream {
    match (pattern.rising(), pattern.falling()) {
        (0, 0) => quote!(None),
        (0, falling) => {
            let falling = hex16(falling);
            quote!(Some(Edge::Falling(#falling)))
        }
        (rising, _) => {
            let rising = hex16(rising);
            quote!(Some(Edge::Rising(#rising)))
        }
    }
}
