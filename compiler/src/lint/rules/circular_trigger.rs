use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A trigger says what writing one value to an entry sets off, and from which others the device then takes its data. The
    /// entry itself has that one value and no data: another one was meant.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Write position to table"
    /// type = "UINT8"
    /// access = "rw"
    /// trigger = { value = 1, action = "Writes the position", uses = ["0x2000"] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Write position to table"
    /// type = "UINT8"
    /// access = "rw"
    /// trigger = { value = 1, action = "Writes the position", uses = ["0x2001"] }
    ///
    /// [objects.0x2001]
    /// name = "Position"
    /// type = "INT32"
    /// access = "rw"
    /// ```
    pub(super) static RULE = "circular-trigger", Dictionary, Warning, "a trigger takes its data from itself";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let Some(trigger) = &entry.trigger else { continue };
        if let Some(place) = trigger.uses.iter().position(|used| *used == entry.address) {
            let name = lookup::name(object, entry);
            let message = format!("the trigger of {name} takes its data from {name} itself");
            let at = entry.origin.value(&format!("trigger.uses.{place}"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "this is where it is triggered");
            report.push(name, diagnostic.help("name the object that has the data, or leave it out"));
        }
    }
}
