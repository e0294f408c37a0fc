use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Meaning, Place, Section};
use crate::source::Location;

rule! {
    /// Two values of one object that have the same name cannot be told apart by it; one of the two is mostly a
    /// misprint. Values that are reserved may share that word, and an `about` that differs tells two apart.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "State"
    /// type = "UINT8"
    /// values = { 1 = "stopped", 2 = "stopped" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "State"
    /// type = "UINT8"
    /// values = { 1 = "stopped", 2 = "running", 3 = "reserved", 4 = "reserved" }
    /// ```
    pub(super) static RULE = "ambiguous-value-name", Values, Warning, "two values have one name";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let at = lookup::name(object, entry);
        judge(&at, &entry.values, entry.origin.value("values"), report);
    }
    for word in &device.words {
        for field in &word.fields {
            let at = Section::Words.at(&word.id).at(field.low);
            let place = word.origin.value(&(field.path("bits") + ".values"));
            judge(&at, &field.values, place, report);
        }
    }
}

fn judge(at: &Place, values: &[Meaning], place: Location, report: &mut Report) {
    let mut first = BTreeMap::new();
    for meaning in values.iter().filter(|meaning| !meaning.name.to_lowercase().starts_with("reserved")) {
        let key = (meaning.name.to_lowercase(), &meaning.about);
        let Some(other) = first.get(&key) else {
            first.insert(key, meaning.value);
            continue;
        };
        let message = format!("{other} and {} both mean `{}` at {at}", meaning.value, meaning.name);
        let diagnostic = Diagnostic::new(&RULE, message, place, "one name twice");
        report.push(at.clone(), diagnostic.help("give each an `about` that tells them apart"));
    }
}
