use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// What a master sends in process data is taken in Operational. A value that can be written in other states only is a
    /// setting: mapped as an output, it would be refused or ignored in each cycle.
    ///
    /// What a profile says of mapping is not held against a description: there it gives way.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Cycle time"
    /// type = "UINT16"
    /// access = "rw"
    /// written = "pre-op"
    /// pdo = "rx"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Cycle time"
    /// type = "UINT16"
    /// access = "rw"
    /// written = "pre-op"
    /// ```
    pub(super) static RULE = "unwritable-output", ProcessData, Warning,
        "an output cannot be written where process data is sent";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let Some(window) = entry.written.filter(|window| entry.pdo.rx() && !window.states()[2]) else {
            continue;
        };
        let name = lookup::name(object, entry);
        let message = format!("{name} can be mapped as an output, but is not written in Operational");
        let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value("pdo"), "an output")
            .label(entry.origin.value("written"), format!("written in {} only", window.name()));
        report.push(name, diagnostic.help("leave out one of them: a setting is written by SDO"));
    }
}
