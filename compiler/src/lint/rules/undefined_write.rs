use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Address, Device, Place, Section, Value};
use crate::source::Location;

rule! {
    /// Where each value of an object has a meaning, a configuration or a step of a procedure that writes another one asks for
    /// something that nobody explains, and that the device may not have.
    ///
    /// Only lists of two values and more without gaps are judged, as for a default.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT8"
    /// access = "rw"
    /// values = { 1 = "linear", 2 = "smooth" }
    ///
    /// [procedures.soften]
    /// name = "Soften the start"
    /// steps = [{ do = "Choose the smooth ramp.", object = "0x2000", write = 3 }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT8"
    /// access = "rw"
    /// values = { 1 = "linear", 2 = "smooth" }
    ///
    /// [procedures.soften]
    /// name = "Soften the start"
    /// steps = [{ do = "Choose the smooth ramp.", object = "0x2000", write = 2 }]
    /// ```
    pub(super) static RULE = "undefined-write", Values, Warning,
        "a value that is written is none of those that have a meaning";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in &device.configurations {
        for (i, chosen) in configuration.writes.iter().enumerate() {
            let place = Section::Configurations.at(&configuration.id).at(format!("writes.{i}"));
            judge(device, (chosen.write.address, &chosen.value), (place, chosen.at), report);
        }
    }
    for procedure in &device.procedures {
        for (i, step) in procedure.steps.iter().enumerate() {
            let Some(written) = step.address.zip(step.write.as_ref()) else { continue };
            let path = format!("steps.{i}");
            let at = procedure.origin.value(&format!("{path}.write"));
            judge(device, written, (Section::Procedures.at(&procedure.id).at(path), at), report);
        }
    }
}

fn judge(device: &Device, written: (Address, &Value), (place, at): (Place, Location), report: &mut Report) {
    let (address, value) = written;
    let Some(entry) = device.entry(address) else { return };
    let Some(((first, last), number)) = lookup::all_values(entry).zip(value.integer()) else { return };
    if !(first..=last).contains(&number) {
        let message = format!("{number} is written to {address}, whose values are {first} to {last}");
        let diagnostic = Diagnostic::new(&RULE, message, at, "has no meaning")
            .label(entry.origin.value("values"), format!("{first} to {last} have one"))
            .help("write one of them, or say there what this one means");
        report.push(place, diagnostic);
    }
}
