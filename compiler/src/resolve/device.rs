//! One device, part by part.

use super::context::Context;
use super::derived::{self, Basis};
use super::kept::{self, sorted};
use super::names::Names;
use super::{
    axes, closed, configurations, coordinates, front, mappability, modes, objects, pdos, restated,
    sync_managers, units, words,
};
use crate::diagnostic::Diagnostics;
use crate::model::{
    Arrangement, Device, Eeprom, Hex, Object, Parameter, Pdo, Picture, Repeated, Repetition, Slots, Tables,
    repetitions,
};
use crate::raw::{RawAxes, RawDevice};

/// Resolves a device; what cannot be resolved is reported and left out. None if it has no name or no identity, which
/// was reported before.
pub(super) fn device(mut raw: RawDevice, diagnostics: &mut Diagnostics) -> Option<Device> {
    let context = &mut context(&mut raw, diagnostics);
    closed::judge(context, &raw);
    let (head, identity) = (raw.head?, raw.identity?);
    let mut described = objects::objects(context, raw.objects);
    let modules = sorted(raw.modules, |module| module.ident);
    let slots =
        Slots { axes: &context.axes, shifts: &context.shifts, modules: &modules, profile: head.profile };
    restated::fill(&mut described.objects, &head, &identity, raw.axes.as_ref(), &slots);
    let pdos = pdos::of_both_ways(context, [&raw.rx_pdos, &raw.tx_pdos], &described.objects);
    mappability::settle(&mut described.objects, &pdos);
    let raw_pdos: Vec<_> = raw.rx_pdos.iter().chain(&raw.tx_pdos).collect();
    let sync_managers = sync_managers::sync_managers(context, raw.sync_managers, &raw_pdos, &pdos);
    let (mailbox, origin) = (raw.mailbox.as_ref(), &head.origin);
    let basis = Basis { pdos: &pdos, sync_managers: &sync_managers, mailbox, origin };
    let objects = derived::dictionary(context, described, &basis);
    let configurations = configurations::configurations(context, raw.configurations, &objects, &basis);
    let words = words::words(context, raw.words, &objects);
    let repetitions = repeated(context, &objects, &pdos);
    #[rustfmt::skip] // a line for what belongs together
    let device = Device {
        id: raw.id,
        group: head.group.unwrap_or_else(|| format!("{} drives", head.vendor)),
        type_name: head.type_name.unwrap_or_else(|| head.name.replace(' ', "-")),
        physics: head.physics.unwrap_or_else(|| "YY".to_owned()),
        name: head.name, names: head.names, url: head.url, urls: head.urls, vendor: head.vendor, title: head.title, about: head.about,
        image: head.image.zip(head.image_bytes).map(|(file, bytes)| Picture { file, bytes: Hex(bytes) }),
        models: head.models, profile: head.profile, source: head.source, origin: head.origin,
        identity, ebus_current: head.ebus_current, no_lrw: head.no_lrw, eeprom: raw.eeprom.unwrap_or_else(eeprom), limits: raw.limits,
        axes: context.axes.clone(), arrangement: arrangement(context, raw.axes), modules, slots: raw.slots,
        connectors: raw.connectors, leds: raw.leds,
        communication_states: sorted(raw.communication_states, |state| state.code),
        communication_transitions: raw.communication_transitions,
        al_status_codes: sorted(raw.al_status_codes, |code| code.code),
        abort_codes: sorted(raw.abort_codes, |code| code.code),
        sync_managers, mailbox: raw.mailbox, timeouts: raw.timeouts,
        sync_modes: kept::sync_modes(raw.sync_modes), cycle_times: raw.cycle_times, dead_time: raw.dead_time,
        pdos: by_direction(pdos), configurations, words,
        states: raw.states, commands: raw.commands,
        transitions: sorted(raw.transitions, |transition| transition.number),
        device_control: raw.device_control,
        modes: modes::modes(context, raw.modes), mode_changes: raw.mode_changes, stop_options: raw.stop_options,
        homing_methods: kept::homing_methods(raw.homing_methods),
        errors: kept::errors(raw.errors), vendor_codes: sorted(raw.vendor_codes, |code| code.code),
        diagnosis: sorted(raw.diagnosis, |message| message.text_id),
        units: units::units(context, raw.units), coordinates: context.names.coordinates(),
        areas: sorted(raw.areas, |area| (area.first, area.last)), repetitions,
        enumerations: std::mem::take(&mut context.enumerations), objects,
        registers: sorted(raw.registers, |register| register.address), telegrams: raw.telegrams,
        master_settings: raw.master_settings,
        parameters: parameters(context, raw.parameters),
        procedures: front::procedures(context, raw.procedures),
        documents: raw.documents, errata: raw.errata, remarks: raw.remarks, assumptions: raw.assumptions,
        written: Tables(raw.written),
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
    context
}

/// What repeats from axis to axis.
fn repeated(context: &Context<'_>, objects: &[Object], pdos: &[Pdo]) -> Vec<Repetition> {
    let objects = objects.iter().map(|object| object as &dyn Repeated);
    let pdos = pdos.iter().map(|pdo| pdo as &dyn Repeated);
    repetitions(objects.chain(pdos), context.axes.len())
}

/// The EEPROM of a description that says nothing of it.
fn eeprom() -> Eeprom {
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
fn parameters(context: &Context<'_>, mut parameters: Vec<Parameter>) -> Vec<Parameter> {
    for parameter in &mut parameters {
        let element = if parameter.has_elements() { "[0]" } else { "" };
        parameter.address = context.names.coordinate(&format!("{}{element}", parameter.id));
    }
    parameters
}
