use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// Where each value of an object has a meaning, the default should have one, too; else a reader of a device
    /// that was just switched on finds a value that nobody explains.
    ///
    /// Only lists of two values and more without gaps are judged, and only for objects without a unit: a few
    /// special values among many are no list of all.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "State"
    /// type = "UINT8"
    /// default = 0
    /// values = { 1 = "stopped", 2 = "running" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "State"
    /// type = "UINT8"
    /// default = 1
    /// values = { 1 = "stopped", 2 = "running" }
    /// ```
    pub(super) static RULE = "undefined-default", Dictionary, Warning,
        "a default is none of the values that have a meaning";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let Some(default) = entry.default.as_ref().and_then(|default| default.integer()) else { continue };
        let Some((first, last)) = lookup::all_values(entry) else { continue };
        if (first..=last).contains(&default) {
            continue;
        }
        let name = lookup::name(object, entry);
        let message = format!("{name} is {default} by default, but its values are {first} to {last}");
        let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value("default"), "has no meaning")
            .label(entry.origin.value("values"), format!("{first} to {last} have one"))
            .help("say what it means, or correct it");
        report.push(name, diagnostic);
    }
}
