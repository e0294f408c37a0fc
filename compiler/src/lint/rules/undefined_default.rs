use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Place, Section};
use crate::source::Origin;

rule! {
    /// Where each value of an object has a meaning, the default should have one, too; else a reader of a device
    /// that was just switched on finds a value that nobody explains.
    ///
    /// Only lists of two values and more without gaps are judged, and only where there is no unit: a few
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
        judge(default, (first, last), lookup::name(object, entry), &entry.origin, report);
    }
    for parameter in device.parameters.iter().filter(|parameter| parameter.symbol.is_none()) {
        let Some(default) = parameter.default.as_ref().and_then(|default| default.integer()) else {
            continue;
        };
        let ranges = parameter.values.iter().map(|range| (range.first, range.last));
        let Some(all) = lookup::without_gaps(ranges).filter(|(first, last)| first != last) else { continue };
        judge(default, all, Section::Parameters.at(&parameter.id), &parameter.origin, report);
    }
}

/// Reports a default that is none of the values from the first to the last.
fn judge(default: i128, (first, last): (i128, i128), name: Place, origin: &Origin, report: &mut Report) {
    if !(first..=last).contains(&default) {
        let message = format!("{name} is {default} by default, but its values are {first} to {last}");
        let diagnostic = Diagnostic::new(&RULE, message, origin.value("default"), "has no meaning")
            .label(origin.value("values"), format!("{first} to {last} have one"))
            .help("say what it means, or correct it");
        report.push(name, diagnostic);
    }
}
