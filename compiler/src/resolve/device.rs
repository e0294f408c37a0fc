//! One device, part by part.

use super::context::Context;
use super::derived::{self, Basis};
use super::names::Names;
use super::{
    axes, configurations, control, errors, facts, front, homing, modes, objects, parameters, pdos, registers,
    states, timing, transport, units, words,
};
use crate::diagnostic::Diagnostics;
use crate::model::{Device, Direction, Identity, Pdo};
use crate::raw::{Entity, RawDevice, RawIdentity};
use crate::source::Sources;

/// Resolves a device; what cannot be resolved is reported and left out.
pub(super) fn device(raw: RawDevice, sources: &Sources, diagnostics: &mut Diagnostics) -> Device {
    let mut context = Context {
        sources,
        diagnostics,
        names: Names::default(),
        axes: axes::axes(raw.axes.as_ref()),
        shifts: Vec::new(),
        pdo_shift: raw.axes.as_ref().and_then(|axes| axes.raw.pdo_shift).unwrap_or(0x10),
        documents: facts::documents(&raw.documents),
    };
    let context = &mut context;
    let coordinates = raw.coordinates.as_ref().map(|entity| parameters::coordinates(context, entity));
    context.names = Names::gather(&raw, coordinates);
    context.shifts = axes::shifts(context, raw.axes.as_ref());
    let assumptions = facts::assumptions(context, &raw);

    let described = objects::objects(context, raw.objects);
    let mut pdos = pdos::pdos(context, &raw.rx_pdos, Direction::Rx, &described.objects);
    pdos.extend(pdos::pdos(context, &raw.tx_pdos, Direction::Tx, &described.objects));
    let raw_pdos: Vec<_> = raw.rx_pdos.iter().chain(&raw.tx_pdos).collect();
    let sync_managers = transport::sync_managers(context, raw.sync_managers, &raw_pdos, &pdos);
    let mailbox = raw.mailbox.map(|mailbox| transport::mailbox(context, mailbox));
    let basis = Basis {
        pdos: &pdos,
        sync_managers: &sync_managers,
        mailbox: mailbox.as_ref(),
        origin: &raw.head.origin,
    };
    let objects = derived::dictionary(context, described, &basis);
    let configurations = configurations::configurations(context, raw.configurations, &objects, &basis);

    let states = states::states(context, raw.states);
    let state_ids: Vec<String> = states.iter().map(|state| state.id.clone()).collect();
    let transitions = states::transitions(context, raw.transitions, &state_ids);
    let commands = states::commands(context, raw.commands, &state_ids);
    for command in &commands {
        states::check_numbers(context, &command.transitions, &transitions, &command.origin);
    }
    let device_control =
        raw.device_control.map(|entity| control::device_control(context, entity, &state_ids));
    let communication_states = states::communication_states(context, raw.communication_states);
    let communication_ids: Vec<String> = communication_states.iter().map(|s| s.id.clone()).collect();
    let words = words::words(context, raw.words, &objects);
    let units = units::units(context, raw.units);
    let unit_ids: Vec<String> = units.iter().map(|unit| unit.id.clone()).collect();
    bind_units(context, &objects, &unit_ids);

    let head = raw.head.raw;
    Device {
        id: raw.id,
        group: head.group.unwrap_or_else(|| format!("{} drives", head.vendor)),
        type_name: head.type_name.unwrap_or_else(|| head.name.replace(' ', "-")),
        name: head.name,
        vendor: head.vendor,
        title: head.title,
        about: head.about,
        models: head.models,
        profile: head.profile,
        physics: head.physics.unwrap_or_else(|| "YY".to_owned()),
        identity: identity(context, raw.identity),
        eeprom: transport::eeprom(raw.eeprom),
        axes: context.axes.clone(),
        shifts: context.shifts.clone(),
        pdo_shift: context.pdo_shift,
        coupling: raw.axes.and_then(|axes| axes.raw.coupling),
        areas: axes::areas(context, raw.areas),
        sync_managers,
        mailbox,
        words,
        states,
        commands,
        transitions,
        device_control,
        communication_transitions: states::communication_transitions(
            context,
            raw.communication_transitions,
            &communication_ids,
        ),
        communication_states,
        modes: modes::modes(context, raw.modes),
        mode_changes: modes::changes(context, raw.mode_changes),
        stop_options: modes::stop_options(context, raw.stop_options),
        errors: errors::errors(context, raw.errors),
        vendor_codes: errors::vendor_codes(context, raw.vendor_codes),
        units,
        sync_modes: timing::sync_modes(context, raw.sync_modes),
        cycle_times: timing::cycle_times(context, raw.cycle_times),
        dead_time: raw.dead_time.map(|entity| timing::dead_time(context, entity)),
        leds: front::leds(context, raw.leds),
        connectors: front::connectors(context, raw.connectors),
        parameters: parameters::parameters(context, raw.parameters),
        homing_methods: homing::methods(context, raw.homing_methods),
        registers: registers::registers(context, raw.registers),
        al_status_codes: registers::al_status_codes(context, raw.al_status_codes),
        telegrams: registers::telegrams(context, raw.telegrams),
        configurations,
        limits: front::limits(context, raw.limits),
        coordinates: context.names.coordinates(),
        master_settings: front::master_settings(context, raw.master_settings),
        procedures: front::procedures(context, raw.procedures),
        assumptions,
        remarks: facts::remarks(context, raw.remarks),
        errata: facts::errata(context, raw.errata),
        objects,
        documents: context.documents.clone(),
        pdos: by_direction(pdos),
        origin: raw.head.origin,
    }
}

fn by_direction(mut pdos: Vec<Pdo>) -> Vec<Pdo> {
    pdos.sort_by_key(|pdo| (pdo.direction, pdo.index));
    pdos
}

fn identity(context: &Context<'_>, entity: Entity<RawIdentity>) -> Identity {
    let Entity { raw, facts, origin, .. } = entity;
    Identity {
        vendor_id: raw.vendor_id,
        product_code: raw.product_code,
        revision: raw.revision,
        serial: raw.serial.unwrap_or(0),
        source: facts::source(context, &facts),
        origin,
    }
}

/// Reports units that entries name and nobody describes.
fn bind_units(context: &mut Context<'_>, objects: &[crate::model::Object], known: &[String]) {
    for entry in objects.iter().flat_map(|object| &object.entries) {
        if let Some(unit) = &entry.unit {
            context.bind(unit, known, "unit", entry.origin.value("unit"));
        }
    }
}
