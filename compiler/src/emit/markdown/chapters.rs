//! The chapters, one file each.

mod axes;
mod communication;
mod configurations;
mod connections;
mod coordinates;
mod device;
mod errors;
mod homing;
mod modes;
mod objects;
mod process_data;
mod registers;
mod service;
mod sources;
mod states;
mod stopping;
mod synchronisation;
mod units;
mod words;

use device::Head;

use super::chapter::{Prepared, prepare};
use super::context::Context;
use crate::model::Device;

/// The chapters of a device, in the order of the document. Each is given what it is about: a part of the device
/// that no chapter takes does not go unseen here.
pub(super) fn chapters(context: &Context<'_>) -> Vec<Prepared> {
    #[rustfmt::skip] // a line for what belongs together
    let Device {
        // the word, the name and the title stand at the front of the document
        id: _, name: _, title: _,
        // what it repeats, and who said what, stands where it belongs
        repetitions: _, written: _,
        vendor, about, models, group, type_name, profile, physics, identity, eeprom, limits, source, origin,
        axes, arrangement, connectors, leds,
        communication_states, communication_transitions, al_status_codes, sync_managers, mailbox,
        sync_modes, cycle_times, dead_time,
        pdos, configurations, words,
        states, commands, transitions, device_control,
        modes, mode_changes, homing_methods, stop_options,
        errors, vendor_codes, units, coordinates,
        areas, objects, registers, telegrams,
        master_settings, parameters, procedures,
        documents, errata, remarks, assumptions,
    } = context.device;
    let (about, source, profile) = (about.as_deref(), source.as_ref(), *profile);
    #[rustfmt::skip] // as above
    let head = Head {
        vendor, about, models, group, type_name, profile, physics, identity, eeprom, limits, source, origin,
    };
    let link_layer = (
        &**communication_states,
        &**communication_transitions,
        &**al_status_codes,
        &**sync_managers,
        mailbox.as_ref(),
    );
    let chapters = [
        prepare::<device::View>(context, head),
        prepare::<axes::View>(context, (axes, arrangement)),
        prepare::<connections::View>(context, (connectors, leds)),
        prepare::<communication::View>(context, link_layer),
        prepare::<synchronisation::View>(context, (sync_modes, cycle_times, dead_time.as_ref())),
        prepare::<process_data::View>(context, pdos),
        prepare::<configurations::View>(context, configurations),
        prepare::<words::View>(context, words),
        prepare::<states::View>(context, (states, commands, transitions, device_control.as_ref())),
        prepare::<modes::View>(context, (modes, mode_changes, device_control.as_ref())),
        prepare::<homing::View>(context, homing_methods),
        prepare::<stopping::View>(context, stop_options),
        prepare::<errors::View>(context, (errors, vendor_codes)),
        prepare::<units::View>(context, units),
        prepare::<coordinates::View>(context, coordinates.as_ref()),
        prepare::<objects::View>(context, (areas, objects)),
        prepare::<registers::View>(context, (registers, telegrams)),
        prepare::<service::View>(context, (master_settings, parameters, procedures)),
        prepare::<sources::View>(context, (documents, errata, remarks, assumptions)),
    ];
    chapters.into_iter().flatten().collect()
}
