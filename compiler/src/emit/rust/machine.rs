//! The state machine as a whole: what the runtime's drive and master run on.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::doc::Doc;
use super::item::{Item, Space};
use super::literal::{hex16, number};
use super::names::Names;
use super::scope::Scope;
use super::{commands, states};
use crate::model::{Device, Event, HomingBits, Mode, ModeChange, Refusal};

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let device = scope.device;
    let mut names = Names::default();
    let homing = device.modes.iter().filter_map(|mode| homing(scope, mode, &mut names));
    if device.states.is_empty() || device.transitions.is_empty() {
        return homing.collect();
    }
    let name = |name: &str| format_ident!("{name}");
    let conditions = Item::new(name("CONDITIONS"), || conditions(device)).of(&device.transitions);
    let modes = Item::new(name("MODES"), || modes(device));
    let modes = modes.of(&device.modes).of(&device.mode_changes).of(&device.device_control);
    let machine = Item::new(name("MACHINE"), || machine(scope)).of(&device.device_control);
    let commands = device.given().next().map(|_| name("commands"));
    let parts = ["STATES", "TRANSITIONS", "CONDITIONS", "MODES"].map(name).into_iter().chain(commands);
    let machine = machine.each(parts, |machine, part| machine.using(Space::Root, &part));
    [conditions, modes].into_iter().chain(homing).chain([machine]).collect()
}

fn machine(scope: &Scope<'_>) -> (Doc, TokenStream) {
    let control = scope.device.device_control.as_ref();
    let commands = commands::list(scope.device);
    let refusal = refusal(control.map_or(Refusal::Ignored, |control| control.wrong_command));
    let doc = Doc::new("The state machine, as both sides run it.")
        .maybe(control.and_then(|control| control.about.as_deref()));
    let doc = match control {
        Some(control) => doc.said(control.source.as_ref(), &control.origin, scope.device),
        None => doc,
    };
    let code = quote! {
        pub const MACHINE: Machine = Machine {
            states: STATES,
            commands: #commands,
            transitions: TRANSITIONS,
            conditions: CONDITIONS,
            refusal: #refusal,
            modes: MODES,
        };
    };
    (doc, code)
}

fn refusal(refusal: Refusal) -> TokenStream {
    match refusal {
        Refusal::Ignored => quote!(Refusal::Ignored),
        Refusal::Fault => quote!(Refusal::Fault),
    }
}

/// What makes transitions, the most urgent first, then what hinders them.
fn conditions(device: &Device) -> (Doc, TokenStream) {
    let caused = device.caused().into_iter().map(|one| ("caused", one, &one.events));
    let hindered = device.transitions.iter().filter(|one| one.supported && !one.interlocks.is_empty());
    let hindered = hindered.map(|one| ("hindered", one, &one.interlocks));
    let rows = caused.chain(hindered).map(|(how, transition, of)| {
        let (how, number, events) = (format_ident!("{how}"), number(transition.number), events(of));
        quote!(Condition::#how(#number, #events))
    });
    let doc = Doc::new("What makes or hinders transitions besides commands, the most urgent first.");
    let doc = device
        .transitions
        .iter()
        .filter(|one| one.supported)
        .fold(doc, |doc, one| doc.of_row(one.number, &["events", "interlocks"], &one.origin, device));
    (doc, quote!(pub const CONDITIONS: &[Condition] = &[#(#rows),*];))
}

fn events(events: &[Event]) -> TokenStream {
    let mut names = events.iter().map(|event| event_name(*event));
    let first = names.next().map_or_else(|| quote!(Events::NONE), |name| quote!(Events::#name));
    names.fold(first, |all, name| quote!(#all.and(Events::#name)))
}

fn event_name(event: Event) -> Ident {
    let name = match event {
        Event::Initialised => "INITIALISED",
        Event::Fault => "FAULT",
        Event::FaultReactionOver => "FAULT_REACTION_OVER",
        Event::QuickStopOver => "QUICK_STOP_OVER",
        Event::LockedOut => "LOCKED_OUT",
        Event::NotEnabled => "NOT_ENABLED",
    };
    format_ident!("{name}")
}

fn modes(device: &Device) -> (Doc, TokenStream) {
    let supported = device.mode_codes().into_iter().map(number);
    let changes = device.mode_changes.iter().map(change);
    let control = device.device_control.as_ref();
    let refusal = refusal(control.map_or(Refusal::Ignored, |control| control.wrong_mode));
    let states = control.map_or(&[][..], |control| &control.modes_selectable_in);
    let states = states.iter().filter_map(|id| states::state(id)).map(|name| quote!(State::#name));
    let states: Vec<TokenStream> = states.collect();
    let selectable_in =
        if states.is_empty() { quote!(StateSet::ALL) } else { quote!(StateSet::of(&[#(#states),*])) };
    let code = quote! {
        pub const MODES: Modes = Modes {
            supported: &[#(#supported),*],
            changes: &[#(#changes),*],
            selectable_in: #selectable_in,
            refusal: #refusal,
        };
    };
    let doc =
        Doc::new("The modes of operation by their numbers, and how the drive goes from one to another.");
    let doc = device.mode_changes.iter().fold(doc, |doc, change| {
        let listed = |codes: &[i16]| codes.iter().map(i16::to_string).collect::<Vec<_>>().join(", ");
        let row = format!("{} to {}", listed(&change.from), listed(&change.to));
        doc.of_row(row, &["from", "to"], &change.origin, device)
    });
    (doc, code)
}

fn change(change: &ModeChange) -> TokenStream {
    let (from, to) = (codes(&change.from), codes(&change.to));
    quote!(ModeChange { from: &[#(#from),*], to: &[#(#to),*] })
}

/// The codes that fit the object of the mode, which has 8 bits; a rule reports the others.
fn codes(codes: &[i16]) -> Vec<Literal> {
    codes.iter().filter_map(|code| i8::try_from(*code).ok()).map(number).collect()
}

/// The bits of homing, if the mode has them.
fn homing<'s>(scope: &'s Scope<'_>, mode: &'s Mode, names: &mut Names) -> Option<Item<'s>> {
    let bits = mode.homing_bits?;
    let name = names.claim(&format_ident!("HOMING"));
    Some(Item::new(name.clone(), move || homing_bits(scope, mode, bits, &name)).of(mode))
}

fn homing_bits(scope: &Scope<'_>, mode: &Mode, bits: HomingBits, name: &Ident) -> (Doc, TokenStream) {
    let mask = |bit: u8| hex16(1_u16.checked_shl(bit.into()).unwrap_or(0));
    let HomingBits { start, reached, attained, error } = bits;
    let (start, reached, attained, error) = (mask(start), mask(reached), mask(attained), mask(error));
    let title = format!("The bits that start a reference run in mode {} and show how far it is.", mode.code);
    let doc = Doc::new(title).said(mode.source.as_ref(), &mode.origin, scope.device);
    let code = quote! {
        pub const #name: HomingBits = HomingBits {
            start: #start,
            reached: #reached,
            attained: #attained,
            error: #error,
        };
    };
    (doc, code)
}
