//! The states of the drive and how it goes from one to another.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::doc::{Doc, escape, place};
use super::literal::{hex16, line, number, parsed};
use super::names::camel;
use super::scope::Scope;
use crate::model::{Device, Scope as Axes, State, Transition};

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    let device = scope.device;
    let patterns = (!device.states.is_empty()).then(|| (patterns(device), texts(device)));
    let (patterns, texts) = patterns.unzip();
    let transitions = (!device.transitions.is_empty()).then(|| transitions(device));
    quote!(#patterns #texts #transitions)
}

/// The runtime's name of a state.
pub(super) fn state(id: &str) -> Option<Ident> {
    State::OF_PROFILE.contains(&id).then(|| camel(id))
}

fn patterns(device: &Device) -> TokenStream {
    let row = |one: &State| {
        let (name, pattern) = (state(&one.id)?, one.pattern.as_ref()?);
        let (mask, value) = (hex16(pattern.mask()), hex16(pattern.value()));
        Some(quote!((State::#name, Pattern { mask: #mask, value: #value })))
    };
    let rows = device.states.iter().filter_map(row);
    let doc = Doc::new("How the statusword shows the states, bit 7 first.");
    let doc = device.states.iter().fold(doc, |doc, state| {
        let pattern = state.pattern.as_ref().map_or(String::new(), |pattern| format!(" `{pattern}`"));
        let source =
            state.source.as_ref().map_or(String::new(), |source| format!(" ({})", place(source, device)));
        let text = escape(&format!("{}{source}", text(state)));
        doc.text(&format!("*{}*{pattern}: {text}", escape(&state.name)))
    });
    quote! {
        #doc
        pub const STATES: StatePatterns = StatePatterns(&[#(#rows),*]);
    }
}

/// What the description says of the states.
fn texts(device: &Device) -> TokenStream {
    let arms: Vec<TokenStream> = device
        .states
        .iter()
        .filter_map(|one| Some((state(&one.id)?, text(one))))
        .filter(|(_, text)| !text.is_empty())
        .map(|(name, text)| quote!(State::#name => #text,))
        .collect();
    if arms.is_empty() {
        return TokenStream::new();
    }
    let rest = (arms.len() < State::OF_PROFILE.len()).then(|| quote!(_ => "",));
    let text = parsed("&'static str");
    quote! {
        /// What the description says of a state; empty if nothing.
        pub const fn state_text(state: State) -> #text {
            match state {
                #(#arms)*
                #rest
            }
        }
    }
}

/// What a state means and what holds in it.
fn text(state: &State) -> String {
    let parts = state.about.iter().chain(&state.features);
    line(&parts.map(String::as_str).collect::<Vec<_>>().join(" "))
}

fn transitions(device: &Device) -> TokenStream {
    let supported = device.transitions.iter().filter(|transition| transition.supported);
    let rows = supported.clone().filter_map(|one| transition(device, one));
    let doc = Doc::new(
        "The transitions of the drive: number, states before, state after, axes that have to make it.",
    );
    let told = supported.filter_map(|one| Some((one, one.about.as_deref()?)));
    let doc = told.fold(doc, |doc, (one, about)| doc.text(&format!("*{}*: {}", one.number, escape(about))));
    quote! {
        #doc
        pub const TRANSITIONS: &[Transition] = {
            const fn transition(number: u8, from: &[State], to: State, coupling: Coupling) -> Transition {
                Transition { number, from: StateSet::of(from), to, coupling }
            }
            &[#(#rows),*]
        };
    }
}

fn transition(device: &Device, transition: &Transition) -> Option<TokenStream> {
    let (number, to) = (number(transition.number), state(&transition.to)?);
    let from = device.origins(transition).into_iter().filter_map(state).map(|from| quote!(State::#from));
    let coupling = match transition.axes {
        None => quote!(Coupling::Independent),
        Some(Axes::All) => quote!(Coupling::All),
        Some(Axes::Any) => quote!(Coupling::Any),
    };
    Some(quote!(transition(#number, &[#(#from),*], State::#to, #coupling)))
}
