use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Section};

rule! {
    /// `writes` are for what a vendor demands besides. Which PDOs are assigned and what they map, the mode of operation and the
    /// cycle time have keys of their own, and what follows from them is known everywhere: the length of process data, types
    /// for it, and what is judged by mode. A write that makes such a choice by hand is known to nobody, and where a key says
    /// something else, the one that comes last wins.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes]
    /// 6 = {}
    ///
    /// [configurations.homing]
    /// name = "Homing"
    /// writes = [{ entry = "0x6060", value = 6, why = "homing comes first" }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes]
    /// 6 = {}
    ///
    /// [configurations.homing]
    /// name = "Homing"
    /// mode = 6
    /// ```
    pub(super) static RULE = "disguised-choice", ProcessData, Warning,
        "a write chooses what has a key of its own";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in &device.configurations {
        for (i, write) in configuration.writes.iter().enumerate() {
            let Some((what, key)) = choice(device, write.write.address.index.0) else { continue };
            let message = format!("{} is written, which is {what}", write.write.address);
            let diagnostic = Diagnostic::new(&RULE, message, write.at, "written here");
            let diagnostic = match key.iter().find(|key| configuration.origin.has(key)) {
                Some(key) => diagnostic.label(configuration.origin.value(key), "chosen here, too"),
                None => diagnostic,
            };
            let keys = lookup::list(key.iter().map(|key| format!("`{key}`")));
            let place = Section::Configurations.at(&configuration.id).at(format!("writes.{i}"));
            report.push(place, diagnostic.help(format!("say it by {keys} of the configuration")));
        }
    }
}

/// What is chosen by writing an object, and the keys that say it.
fn choice(device: &Device, index: u16) -> Option<(&'static str, &'static [&'static str])> {
    let is_on_an_axis = |of| lookup::on_axes(device, of).any(|object| object.index.0 == index);
    match index {
        0x1C10..=0x1C1F => Some(("the assignment of PDOs", &["outputs", "inputs"])),
        0x1600..=0x17FF | 0x1A00..=0x1BFF => Some(("the mapping of a PDO", &["mapping"])),
        _ if is_on_an_axis(0x6060) => Some(("the mode of operation", &["mode"])),
        _ if is_on_an_axis(0x60C2) => Some(("the cycle time", &["cycle-time"])),
        _ => None,
    }
}
