use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A unit that no value has does nothing: the values that it was meant for are without one, so that nobody can
    /// tell how they are scaled.
    ///
    /// ## Fires
    /// ```toml
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "rpm"
    /// raw-per-unit = 100
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "rpm"
    /// raw-per-unit = 100
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// unit = "speed"
    /// ```
    pub(super) static RULE = "idle-unit", Values, Warning, "no value has a unit that is described";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let entries = device.objects.iter().flat_map(|object| &object.entries);
    let used: BTreeSet<&str> = entries.filter_map(|entry| entry.unit.as_deref()).collect();
    for unit in device.units.iter().filter(|unit| !used.contains(&*unit.id)) {
        let message = format!("no value is in the unit `{}`", unit.id);
        let diagnostic = Diagnostic::new(&RULE, message, unit.origin.header(), "not used")
            .help(format!("write `unit = \"{}\"` where values have it, or take it out", unit.id));
        report.push(Section::Units.at(&unit.id), diagnostic);
    }
}
