use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Place, Section};
use crate::source::{Location, Origin};

rule! {
    /// A name is what people and tools know a thing by. One without a letter leaves a gap in lists and in generated code.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = " "
    /// type = "UINT16"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// ```
    pub(crate) static RULE = "empty-name", Output, Warning, "a name says nothing";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut named: Vec<(Place, &str, Location)> = Vec::new();
    let head = [
        ("name", &device.name),
        ("vendor", &device.vendor),
        ("group", &device.group),
        ("type-name", &device.type_name),
    ];
    named.extend(head.map(|(key, name)| (Section::Device.at(key), name.as_str(), device.origin.value(key))));
    let mut add = |at: Place, name, origin: &Origin| named.push((at, name, origin.value("name")));
    lookup::objects(device).for_each(|it| add(it.index.into(), &it.name, &it.origin));
    let entries = lookup::entries(device).filter(|(object, _)| object.entries.len() > 1);
    entries.for_each(|(_, it)| add(it.address.into(), &it.name, &it.origin));
    device.pdos.iter().for_each(|it| add(it.index.into(), &it.name, &it.origin));
    device.states.iter().for_each(|it| add(Section::States.at(&it.id), &it.name, &it.origin));
    device.commands.iter().for_each(|it| add(Section::Commands.at(&it.id), &it.name, &it.origin));
    device.modes.iter().for_each(|it| add(Section::Modes.at(it.code), &it.name, &it.origin));
    device.errors.iter().for_each(|it| add(it.place(), &it.name, &it.origin));
    device.words.iter().for_each(|it| add(Section::Words.at(&it.id), &it.name, &it.origin));
    for (at, _, place) in named.into_iter().filter(|(_, name, _)| name.trim().is_empty()) {
        let message = format!("{at} has an empty name");
        report.push(at, Diagnostic::new(&RULE, message, place, "nothing is in it"));
    }
}
