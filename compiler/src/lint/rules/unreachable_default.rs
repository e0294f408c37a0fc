use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Place, Section, Value};
use crate::source::Origin;

rule! {
    /// A default outside the limits is a value that nobody could write: either it or a limit is wrong.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gain"
    /// type = "INT16"
    /// access = "rw"
    /// min = 10
    /// default = 0
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gain"
    /// type = "INT16"
    /// access = "rw"
    /// min = 10
    /// default = 10
    /// ```
    pub(super) static RULE = "unreachable-default", Dictionary, Warning,
        "a default is outside the limits";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let values = [&entry.default, &entry.min, &entry.max].map(Option::as_ref);
        judge(values, KEYS, &entry.origin, lookup::name(object, entry), report);
    }
    for parameter in &device.parameters {
        let values = [&parameter.default, &parameter.min, &parameter.max].map(Option::as_ref);
        judge(values, KEYS, &parameter.origin, Section::Parameters.at(&parameter.id), report);
    }
    for pdo in &device.pdos {
        let Some(often) = pdo.oversampling.as_ref() else { continue };
        let values = [Some(often.factor), often.min, often.max].map(|factor| factor.map(i64::from));
        let values = values.map(|factor| factor.map(Value::Integer));
        let keys = ["oversampling.factor", "oversampling.min", "oversampling.max"];
        let name = Place::from(pdo.index).at("oversampling");
        judge(values.each_ref().map(Option::as_ref), keys, &pdo.origin, name, report);
    }
}

/// The keys of a default, the least and the greatest value.
const KEYS: [&str; 3] = ["default", "min", "max"];

/// Judges a default by the least and the greatest value.
fn judge(
    values: [Option<&Value>; 3],
    [default_key, min_key, max_key]: [&'static str; 3],
    origin: &Origin,
    name: Place,
    report: &mut Report,
) {
    let [Some(default), min, max] = values else { return };
    let limits = [(min, min_key), (max, max_key)];
    let Some((limit, side, key)) = lookup::beyond(default, limits) else { return };
    let message = format!("{name} is {default} by default, {side} its limit {limit}");
    let at = origin.value(default_key);
    let diagnostic = Diagnostic::new(&RULE, message, at, format!("{side} {limit}"));
    report.push(name, diagnostic.label(origin.value(key), "the limit"));
}
