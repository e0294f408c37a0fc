//! The texts that travel to other tools.

use std::borrow::Cow;

use crate::model::{Device, Field, Place, Section};
use crate::source::{Location, Origin};

/// A text, what it belongs to by the name that errata use, and where it stands.
pub(super) struct Text<'d> {
    pub(super) at: Place,
    pub(super) place: Location,
    pub(super) text: &'d str,
}

/// The names that a configuration tool shows and that an EEPROM image holds.
pub(super) fn names(device: &Device) -> impl Iterator<Item = Text<'_>> {
    let head = [
        ("name", &device.name),
        ("type-name", &device.type_name),
        ("group", &device.group),
        ("vendor", &device.vendor),
    ];
    let text = |at: Place, place, text| Text { at, place, text };
    // What is made from another name has its faults.
    let written = head.into_iter().filter(|(key, _)| device.origin.has(key));
    let head = written
        .map(move |(key, name)| text(Section::Device.at(key), device.origin.value(key), name.as_str()));
    let pdos = device.pdos.iter();
    let pdos = pdos.map(move |pdo| text(pdo.index.into(), pdo.origin.value("name"), &pdo.name));
    let modes = device.sync_modes.iter();
    let modes = modes.map(move |it| text(Section::SyncModes.at(&it.id), it.origin.value("name"), &it.name));
    head.chain(pdos).chain(modes)
}

/// Where most tables have a name.
const NAME: Cow<'static, str> = Cow::Borrowed("name");

/// A name as it is written.
pub(super) struct Named<'d> {
    pub(super) at: Place,
    pub(super) name: &'d str,
    pub(super) origin: &'d Origin,
    /// Where the table of the origin has it.
    pub(super) path: Cow<'static, str>,
}

/// The names that people know parts of a device by.
pub(super) fn named(device: &Device) -> Vec<Named<'_>> {
    let mut all = Vec::new();
    let mut add = |at: Place, name, origin| all.push(Named { at, name, origin, path: NAME });
    for object in &device.objects {
        add(object.index.into(), object.name.as_str(), &object.origin);
        let entries = object.entries.iter().filter(|_| object.entries.len() > 1);
        entries.for_each(|it| add(it.address.into(), &it.name, &it.origin));
    }
    device.pdos.iter().for_each(|it| add(it.index.into(), &it.name, &it.origin));
    device.errors.iter().for_each(|it| add(it.place(), &it.name, &it.origin));
    device.words.iter().for_each(|it| add(Section::Words.at(&it.id), &it.name, &it.origin));
    all.extend(of_machine(device));
    all.extend(choices(device));
    all.extend(bits(device));
    all
}

/// The names of states, commands and modes.
pub(super) fn of_machine(device: &Device) -> impl Iterator<Item = Named<'_>> {
    let named = |at: Place, name, origin| Named { at, name, origin, path: NAME };
    let states = device.states.iter();
    let states = states.map(move |it| named(Section::States.at(&it.id), &*it.name, &it.origin));
    let commands = device.commands.iter();
    let commands = commands.map(move |it| named(Section::Commands.at(&it.id), &*it.name, &it.origin));
    let modes = device.modes.iter();
    let modes = modes.map(move |it| named(Section::Modes.at(it.code), &*it.name, &it.origin));
    states.chain(commands).chain(modes)
}

/// The names of what people choose among, and look for, outside the dictionary.
pub(super) fn choices(device: &Device) -> Vec<Named<'_>> {
    let mut all = Vec::new();
    macro_rules! named {
        ($($field:ident by $key:ident: $section:ident,)+) => {
            $(
                all.extend(device.$field.iter().map(|it| Named {
                    at: Section::$section.at(&it.$key),
                    name: &it.name,
                    origin: &it.origin,
                    path: NAME,
                }));
            )+
        };
    }
    named! {
        configurations by id: Configurations,
        sync_modes by id: SyncModes,
        cycle_times by id: CycleTimes,
        slots by id: Slots,
        modules by ident: Modules,
        telegrams by id: Telegrams,
        leds by id: Leds,
        connectors by id: Connectors,
        limits by id: Limits,
        procedures by id: Procedures,
    }
    let settings = device.master_settings.iter().enumerate();
    all.extend(settings.map(|(i, it)| Named {
        at: Section::MasterSettings.at(i),
        name: &it.name,
        origin: &it.origin,
        path: NAME,
    }));
    all
}

/// The names of bits, in words and as modes have them.
fn bits(device: &Device) -> impl Iterator<Item = Named<'_>> {
    let words = device.words.iter().map(|it| (Section::Words.at(&it.id), &it.origin, "bits", &it.fields));
    let modes = device.modes.iter().flat_map(|it| {
        let of_mode = [("control-bits", &it.control_bits), ("status-bits", &it.status_bits)];
        of_mode.map(|(key, fields)| (Section::Modes.at(it.code).at(key), &it.origin, key, fields))
    });
    words.chain(modes).flat_map(|(at, origin, key, fields)| {
        let is_named = |field: &&Field| !field.reserved && !field.per_mode;
        fields.iter().filter(is_named).map(move |field| {
            let path = field.path(key);
            let long = format!("{path}.name");
            let path = if origin.has(&long) { long } else { path };
            Named { at: at.clone().at(field.low), name: &field.name, origin, path: path.into() }
        })
    })
}
