use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, texts};
use crate::model::{Device, Section};

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
    let head = [
        ("name", &device.name),
        ("vendor", &device.vendor),
        ("group", &device.group),
        ("type-name", &device.type_name),
    ];
    let head = head.map(|(key, name)| (Section::Device.at(key), name.as_str(), device.origin.value(key)));
    let named = texts::named(device).into_iter();
    let named = named.map(|named| (named.at, named.name, named.origin.value(&named.path)));
    for (at, _, place) in head.into_iter().chain(named).filter(|(_, name, _)| name.trim().is_empty()) {
        let message = format!("{at} has an empty name");
        report.push(at, Diagnostic::new(&RULE, message, place, "nothing is in it"));
    }
}
