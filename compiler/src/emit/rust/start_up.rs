//! Bring-up: what of the device bears on it, and the start-up list of each configuration that is described.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::chosen;
use super::doc::{Doc, sentence};
use super::item::{Item, Reach};
use super::literal::{hex8, hex16, number, option};
use super::names::{Names, shout};
use super::scope::Scope;
use super::sync_managers;
use crate::model::{Axis, Configuration, Direction, SdoWrite};

/// What of the device bears on its bring-up, and its family if it is alone.
pub(super) fn bring_up<'s>(scope: &'s Scope<'_>) -> Item<'s> {
    Item::new(format_ident!("BRING_UP"), || constant(scope)).reaching(Reach::Own)
}

fn constant(scope: &Scope<'_>) -> (Doc, TokenStream) {
    let (name, member) = (&scope.device.name, number(scope.member));
    let maps = scope.device.mailbox.as_ref().is_none_or(|mailbox| mailbox.pdo_config);
    let objects = Axis::set_objects(&scope.device.axes, &scope.device.objects).into_iter().map(|axis| {
        let [mode, cycle] = [axis.mode, axis.cycle].map(|index| option(index.map(hex16)));
        quote!(AxisObjects { mode: #mode, cycle: #cycle })
    });
    let cycles = scope.device.cycle_times.iter().map(|limit| {
        let least = number(limit.min.map_or(0, |min| min.0));
        let choices = limit.choices.iter().map(|choice| number(choice.0));
        let holds_for = scope.device.limited_use(limit);
        let modes = holds_for.modes.into_iter().map(number);
        let pdos = holds_for.pdos.into_iter().map(hex16);
        quote! {
            CycleLimit {
                least_ns: #least,
                choices_ns: &[#(#choices),*],
                modes: &[#(#modes),*],
                pdos: &[#(#pdos),*],
            }
        }
    });
    let ways = [Direction::Rx, Direction::Tx];
    let [outputs, inputs] = ways.map(|way| option(sync_managers::value(scope, way)));
    let code = quote! {
        pub const BRING_UP: BringUp = BringUp {
            name: #name,
            member: #member,
            outputs: #outputs,
            inputs: #inputs,
            maps: #maps,
            axes: &[#(#objects),*],
            cycles: &[#(#cycles),*],
        };
    };
    let doc = Doc::new("What of the device bears on its bring-up, and on what process data it takes.");
    let doc = ways.into_iter().fold(doc, |doc, way| sync_managers::said(scope, way, doc));
    let doc = scope.device.mailbox.iter().fold(doc, |doc, mailbox| {
        doc.departing(&["pdo-assign", "pdo-config"], &mailbox.origin, scope.device)
    });
    let doc = scope
        .device
        .cycle_times
        .iter()
        .fold(doc, |doc, limit| doc.departing(&["min", "choices", "modes"], &limit.origin, scope.device));
    let pdos = scope.pdos.iter().map(|placed| placed.first);
    let doc = pdos.fold(doc, |doc, pdo| doc.carrying(pdo, scope.device));
    (doc, code)
}

/// The family of a device that is alone.
pub(super) fn family(scope: &Scope<'_>) -> TokenStream {
    let (runtime, marker) = (scope.runtime, &scope.marker);
    quote! {
        impl #runtime::Family for #marker {
            const MEMBERS: &'static [BringUp] = &[BRING_UP];
        }
    }
}

/// The start-up lists of the choices that are described, and the process data that there is then.
pub(super) fn configurations<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let mut names = Names::default();
    let lists = scope.device.configurations.iter().map(|configuration| {
        let name = names.claim(&shout(&configuration.id));
        Item::new(name.clone(), move || list(scope, configuration, &name)).of(configuration)
    });
    let images = scope.device.configurations.iter().filter_map(|it| chosen::item(scope, it));
    lists.chain(images).collect()
}

fn list(scope: &Scope<'_>, configuration: &Configuration, name: &Ident) -> (Doc, TokenStream) {
    let doc = Doc::new(sentence(&configuration.name))
        .maybe(configuration.about.as_deref())
        .text(&configuration.cycle_time.map(|time| cycle(time.0)).unwrap_or_default())
        .said(configuration.source.as_ref(), &configuration.origin, scope.device);
    let count = number(configuration.startup.len());
    let writes = configuration.startup.iter().map(write);
    (doc, quote!(pub const #name: [Write; #count] = [#(#writes),*];))
}

fn cycle(ns: u64) -> String {
    if ns.is_multiple_of(1_000_000) {
        format!("Cycle time: {} ms.", ns / 1_000_000)
    } else {
        format!("Cycle time: {} µs.", ns / 1_000)
    }
}

fn write(write: &SdoWrite) -> TokenStream {
    let (index, subindex) = (hex16(write.address.index.0), number(write.address.subindex));
    let data = write.data.iter().map(|byte| hex8(*byte));
    let what = &write.comment;
    let transition = Some(&write.transition).filter(|transition| *transition != "PS");
    let during = transition.map(|transition| quote!(.during(#transition)));
    quote!(Write::new(Address::new(#index, #subindex), &[#(#data),*], #what)#during)
}
