use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Address, Device, Section};
use crate::source::Location;

rule! {
    /// What a configuration writes twice at one change of the EtherCAT state has the last value, and the other does nothing.
    ///
    /// If the device wants to see one value after the other, an erratum says so with `stands`.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT8"
    /// access = "rw"
    ///
    /// [configurations.soft]
    /// name = "Soft"
    /// writes = [
    ///     { entry = "0x2000", value = 1, why = "The linear ramp." },
    ///     { entry = "0x2000", value = 2, why = "The smooth ramp." },
    /// ]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT8"
    /// access = "rw"
    ///
    /// [configurations.soft]
    /// name = "Soft"
    /// writes = [
    ///     { entry = "0x2000", value = 1, why = "The linear ramp." },
    ///     { entry = "0x2000", value = 2, transition = "SO", why = "The smooth ramp." },
    /// ]
    /// ```
    pub(super) static RULE = "repeated-write", ProcessData, Warning, "a configuration writes one entry twice";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in &device.configurations {
        let mut first: BTreeMap<(Address, &str), Location> = BTreeMap::new();
        for (i, chosen) in configuration.writes.iter().enumerate() {
            let key = (chosen.write.address, chosen.write.transition.as_str());
            if let Some(other) = first.get(&key).copied() {
                let message = format!("{} is written twice at {}", key.0, key.1);
                let diagnostic = Diagnostic::new(&RULE, message, chosen.at, "again here")
                    .label(other, "first here")
                    .help("leave one of them out");
                let place = Section::Configurations.at(&configuration.id).at(format!("writes.{i}"));
                report.push(place, diagnostic);
            }
            first.entry(key).or_insert(chosen.at);
        }
    }
}
