//! One device, part by part.

use super::context::Context;
use super::derived::{self, Basis};
use super::kept::{self, sorted};
use super::names::Names;
use super::{
    axes, closed, configurations, coordinates, front, mappability, modes, named, objects, pdos, restated,
    sync_managers, units, words,
};
use crate::diagnostic::Diagnostics;
use crate::model::{
    Arrangement, Device, Eeprom, Hex, Object, Parameter, Pdo, Picture, Repeated, Repetition, Slots, Tables,
    repetitions,
};
use crate::raw::{RawAxes, RawDevice, RawHead};

/// Resolves a device; what cannot be resolved is reported and left out. None if it has no name or no identity, which
/// was reported before.
pub(super) fn device(mut raw: RawDevice, diagnostics: &mut Diagnostics) -> Option<Device> {
    let context = &mut context(&mut raw, diagnostics);
    closed::judge(context, &raw);
    #[rustfmt::skip] // by name and whole, so that no section is read and then forgotten
    let RawDevice {
        id, head, identity, eeprom, documents, axes, modules, slots, areas, objects, parameters, units, rx_pdos, tx_pdos,
        sync_managers, mailbox, timeouts, configurations, words, states, commands, transitions, device_control,
        communication_states, communication_transitions, modes, mode_changes, stop_options, homing_methods, errors,
        vendor_codes, diagnosis, sync_modes, cycle_times, dead_time, registers, al_status_codes, abort_codes, telegrams, leds,
        connectors, limits, master_settings, procedures, remarks, errata, assumptions, written,
        // What the family says of itself, what the context has, and what rules are set to.
        family: _, enumerations: _, coordinates: _, offered: _, lints: _,
    } = raw;
    let (head, identity) = (head?, identity?);
    let mut described = objects::objects(context, objects, &pdos::indices(context, [&rx_pdos, &tx_pdos]));
    let modules = sorted(modules, |module| module.ident);
    let of_slots =
        Slots { axes: &context.axes, shifts: &context.shifts, modules: &modules, profile: head.profile };
    restated::fill(&mut described.objects, &head, &identity, axes.as_ref(), &of_slots);
    let pdos = pdos::of_both_ways(context, [&rx_pdos, &tx_pdos], &described.objects);
    mappability::settle(&mut described.objects, &pdos);
    let raw_pdos: Vec<_> = rx_pdos.iter().chain(&tx_pdos).collect();
    let sync_managers = sync_managers::sync_managers(context, sync_managers, &raw_pdos, &pdos);
    let basis =
        Basis { pdos: &pdos, sync_managers: &sync_managers, mailbox: mailbox.as_ref(), origin: &head.origin };
    let objects = derived::dictionary(context, described, &basis);
    let configurations = configurations::configurations(context, configurations, &objects, &basis);
    let words = words::words(context, words, &objects);
    #[rustfmt::skip] // as above
    let RawHead {
        key: _, name, names, url, urls, vendor, title, about, image, image_bytes, models, profile, group, type_name, physics,
        ebus_current, no_lrw, source, origin,
    } = head;
    #[rustfmt::skip] // a line for what belongs together
    let device = Device {
        id,
        group: group.unwrap_or_else(|| Device::usual_group(&vendor)),
        type_name: type_name.unwrap_or_else(|| name.replace(' ', "-")),
        physics: physics.unwrap_or_else(|| "YY".to_owned()),
        image: image.zip(image_bytes).map(|(file, bytes)| Picture { file, bytes: Hex(bytes) }),
        name, names, url, urls, vendor, title, about, models, profile, source, origin,
        identity, ebus_current, no_lrw, eeprom: eeprom.unwrap_or_else(usual_eeprom),
        axes: context.axes.clone(), arrangement: arrangement(context, axes), modules, slots,
        communication_states: sorted(communication_states, |state| state.code), communication_transitions,
        al_status_codes: sorted(al_status_codes, |code| code.code), abort_codes: sorted(abort_codes, |code| code.code),
        sync_managers, mailbox, timeouts, sync_modes: kept::sync_modes(sync_modes), cycle_times, dead_time,
        procedures: front::procedures(context, procedures, &objects), repetitions: repeated(context, &objects, &pdos),
        pdos: by_direction(pdos), configurations, words, objects,
        states, commands, transitions: sorted(transitions, |transition| transition.number), device_control,
        modes: modes::modes(context, modes), mode_changes, stop_options, homing_methods: kept::homing_methods(homing_methods),
        errors: kept::errors(errors), vendor_codes: sorted(vendor_codes, |code| code.code),
        diagnosis: sorted(diagnosis, |message| message.text_id),
        units: units::units(context, units), coordinates: context.names.coordinates(),
        areas: sorted(areas, |area| (area.first, area.last)), enumerations: std::mem::take(&mut context.enumerations),
        registers: sorted(registers, |register| register.address), telegrams, connectors, leds, limits, master_settings,
        parameters: with_addresses(context, parameters), documents, errata, remarks, assumptions, written: Tables(written),
    };
    kept::references(context, &device);
    Some(device)
}

/// What the parts of a device refer to: its axes and its names.
fn context<'d>(raw: &mut RawDevice, diagnostics: &'d mut Diagnostics) -> Context<'d> {
    let mut context = Context {
        diagnostics,
        names: Names::default(),
        axes: axes::axes(raw.axes.as_ref()),
        shifts: Vec::new(),
        pdo_shift: raw.axes.as_ref().and_then(|axes| axes.pdo_shift).unwrap_or(0x10),
        pdos_of_axes: pdos::of_axes(&raw.rx_pdos).chain(pdos::of_axes(&raw.tx_pdos)).collect(),
        enumerations: std::mem::take(&mut raw.enumerations),
    };
    let coordinates = raw.coordinates.take().map(|raw| coordinates::coordinates(&mut context, raw));
    context.names = Names::gather(raw, coordinates);
    context.shifts = axes::shifts(&mut context, raw.axes.as_ref());
    named::judge(&mut context, raw);
    context
}

/// What repeats from axis to axis.
fn repeated(context: &Context<'_>, objects: &[Object], pdos: &[Pdo]) -> Vec<Repetition> {
    let objects = objects.iter().map(|object| object as &dyn Repeated);
    let pdos = pdos.iter().map(|pdo| pdo as &dyn Repeated);
    repetitions(objects.chain(pdos), context.axes.len())
}

/// The EEPROM of a description that says nothing of it.
fn usual_eeprom() -> Eeprom {
    Eeprom { size: Eeprom::USUAL_SIZE, ..Eeprom::default() }
}

/// How the axes share the dictionary.
fn arrangement(context: &Context<'_>, raw: Option<RawAxes>) -> Arrangement {
    // The names stand with the axes, the ranges in the context.
    let RawAxes { key: _, names: _, about: _, shifts: _, pdo_shift: _, add_info, coupling, source, origin } =
        raw.unwrap_or_default();
    Arrangement {
        shifts: context.shifts.clone(),
        pdo_shift: context.pdo_shift,
        add_info,
        coupling,
        source,
        origin,
    }
}

fn by_direction(pdos: Vec<Pdo>) -> Vec<Pdo> {
    sorted(pdos, |pdo| (pdo.direction, pdo.index))
}

/// The settings, each with its place in the dictionary.
fn with_addresses(context: &Context<'_>, mut parameters: Vec<Parameter>) -> Vec<Parameter> {
    for parameter in &mut parameters {
        let element = if parameter.has_elements() { "[0]" } else { "" };
        parameter.address = context.names.coordinate(&format!("{}{element}", parameter.id));
    }
    parameters
}
