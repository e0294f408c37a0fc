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

use communication::Link;
use device::Head;

use super::context::Context;
use super::page::Page;
use crate::model::Device;

/// A chapter: what it is called in links and for people, and what it says.
pub(super) struct Chapter {
    pub(super) anchor: &'static str,
    pub(super) title: &'static str,
    pub(super) page: Page,
}

/// The chapters of a device, in the order of the document. Each is given what it is about: a part of the device
/// that no chapter takes does not go unseen here.
pub(super) fn chapters(context: &Context<'_>) -> Vec<Chapter> {
    #[rustfmt::skip] // a line for what belongs together
    let Device {
        // the word, the name and the title stand at the front of the document
        id: _, name: _, title: _,
        // what it repeats, and who said what, stands where it belongs
        repetitions: _, written: _,
        // the chapters about them go through those that stand for all axes
        pdos: _, objects: _,
        enumerations: _, image: _, // what they say stands with each entry; the picture is for tools
        vendor, about, models, group, type_name, profile, physics, identity, eeprom, limits, source, origin,
        names, ebus_current, no_lrw, url, urls,
        axes, arrangement, modules, slots, connectors, leds,
        communication_states, communication_transitions, al_status_codes, abort_codes,
        sync_managers, mailbox, timeouts, sync_modes, cycle_times, dead_time,
        configurations, words,
        states, commands, transitions, device_control,
        modes, mode_changes, homing_methods, stop_options,
        errors, vendor_codes, diagnosis, units, coordinates,
        areas, registers, telegrams,
        master_settings, parameters, procedures,
        documents, errata, remarks, assumptions,
    } = context.device;
    let (about, source, profile) = (about.as_deref(), source.as_ref(), *profile);
    #[rustfmt::skip] // as above
    let head = Head {
        vendor, about, models, group, type_name, profile, physics, identity, eeprom, limits, source, origin,
        names, ebus_current: *ebus_current, no_lrw: *no_lrw, url: url.as_deref(), urls,
    };
    #[rustfmt::skip] // as above
    let link = Link {
        communication_states, communication_transitions, al_status_codes, abort_codes, sync_managers, mailbox, timeouts,
    };
    let (dead_time, control) = (dead_time.as_ref(), device_control.as_ref());
    let numbering = coordinates.as_ref().map(|it| coordinates::page(context, it)).unwrap_or_default();
    #[rustfmt::skip] // a line for each
    let chapters = [
        ("device", "Device", device::page(context, &head)),
        ("axes", "Axes", axes::page(context, axes, arrangement, (modules, slots))),
        ("connections", "Connections and lights", connections::page(context, connectors, leds)),
        ("communication", "Communication", communication::page(context, &link)),
        ("synchronisation", "Synchronisation", synchronisation::page(context, sync_modes, cycle_times, dead_time)),
        ("process-data", "Process data", process_data::page(context)),
        ("configurations", "Start-up configurations", configurations::page(context, configurations)),
        ("words", "Words", words::page(context, words)),
        ("states", "Drive states", states::page(context, states, commands, transitions, control)),
        ("modes", "Modes of operation", modes::page(context, modes, mode_changes, control)),
        ("homing", "Homing methods", homing::page(context, homing_methods)),
        ("stopping", "Stopping", stopping::page(context, stop_options)),
        ("errors", "Errors", errors::page(context, errors, vendor_codes, diagnosis)),
        ("units", "Units and scaling", units::page(context, units)),
        ("coordinates", "Numbering of parameters", numbering),
        ("objects", "Object dictionary", objects::page(context, areas)),
        ("registers", "Registers and messages", registers::page(context, registers, telegrams)),
        ("service", "Settings and procedures", service::page(context, master_settings, parameters, procedures)),
        ("sources", "Sources", sources::page(context, documents, errata, remarks, assumptions)),
    ];
    let chapters = chapters.into_iter().map(|(anchor, title, page)| Chapter { anchor, title, page });
    chapters.filter(|chapter| !chapter.page.is_empty()).collect()
}
