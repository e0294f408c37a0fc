//! The texts that travel to other tools.

use crate::model::{Device, Place, Section};
use crate::source::Location;

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
