//! The states of the drive and how it goes from one to another.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::doc::{Doc, escape, place};
use super::item::Item;
use super::literal::{hex16, line, number, parsed};
use super::names::camel;
use super::scope::Scope;
use crate::model::{Device, Scope as Axes, State, Transition};

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let device = scope.device;
    let patterns = || Item::new(format_ident!("STATES"), || patterns(device)).of(&device.states);
    let texts = || Item::new(format_ident!("state_text"), || texts(device)).of(&device.states);
    let transitions = || {
        let item = Item::new(format_ident!("TRANSITIONS"), || transitions(device));
        item.of(&device.states).of(&device.transitions)
    };
    let has_texts = device.states.iter().any(|one| state(&one.id).is_some() && !text(one).is_empty());
    let items = [
        (!device.states.is_empty()).then(patterns),
        has_texts.then(texts),
        (!device.transitions.is_empty()).then(transitions),
    ];
    items.into_iter().flatten().collect()
}

/// The runtime's name of a state.
pub(super) fn state(id: &str) -> Option<Ident> {
    State::OF_PROFILE.contains(&id).then(|| camel(id))
}

/// What the table of states and their texts are made of.
const STATE: &[&str] = &["name", "pattern", "about", "features"];

fn patterns(device: &Device) -> (Doc, TokenStream) {
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
        let name = escape(&state.name);
        doc.text(&format!("*{name}*{pattern}: {text}")).of_row(name, STATE, &state.origin, device)
    });
    (doc, quote!(pub const STATES: StatePatterns = StatePatterns(&[#(#rows),*]);))
}

/// What the description says of the states.
fn texts(device: &Device) -> (Doc, TokenStream) {
    let arms: Vec<TokenStream> = device
        .states
        .iter()
        .filter_map(|one| Some((state(&one.id)?, text(one))))
        .filter(|(_, text)| !text.is_empty())
        .map(|(name, text)| quote!(State::#name => #text,))
        .collect();
    let rest = (arms.len() < State::OF_PROFILE.len()).then(|| quote!(_ => "",));
    let text = parsed("&'static str");
    let code = quote! {
        pub const fn state_text(state: State) -> #text {
            match state {
                #(#arms)*
                #rest
            }
        }
    };
    (Doc::new("What the description says of a state; empty if nothing."), code)
}

/// What a state means and what holds in it.
fn text(state: &State) -> String {
    let parts = state.about.iter().chain(&state.features);
    line(&parts.map(String::as_str).collect::<Vec<_>>().join(" "))
}

fn transitions(device: &Device) -> (Doc, TokenStream) {
    let supported = device.transitions.iter().filter(|transition| transition.supported);
    let rows = supported.clone().filter_map(|one| transition(device, one));
    let doc = Doc::new(
        "The transitions of the drive: number, states before, state after, axes that have to make it.",
    );
    let doc = supported.fold(doc, |doc, one| {
        let about = one.about.as_ref().map(|about| format!("*{}*: {}", one.number, escape(about)));
        let doc = doc.text(&about.unwrap_or_default());
        doc.of_row(one.number, &["from", "to", "axes", "supported", "about"], &one.origin, device)
    });
    let code = quote! {
        pub const TRANSITIONS: &[Transition] = {
            const fn transition(number: u8, from: &[State], to: State, coupling: Coupling) -> Transition {
                Transition { number, from: StateSet::of(from), to, coupling }
            }
            &[#(#rows),*]
        };
    };
    (doc, code)
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
