use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Place, Section, Value};
use crate::source::Origin;

rule! {
    /// A value that means something, or sets something off, can be written. If it lies outside of the limits, either the limits
    /// are too narrow, and firmware and masters refuse it, or the value is another one. Of the values that a profile knows, a
    /// device may take some only.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Kind of brake"
    /// type = "UINT8"
    /// max = 1
    /// values = { 0 = "none", 1 = "holding", 2 = "service" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Kind of brake"
    /// type = "UINT8"
    /// max = 2
    /// values = { 0 = "none", 1 = "holding", 2 = "service" }
    /// ```
    pub(super) static RULE = "unreachable-value", Dictionary, Warning,
        "a value with a meaning is outside the limits";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let limits = [&entry.min, &entry.max].map(Option::as_ref);
        // a device need not take each value that its profile knows
        let own = entry.values.iter().filter(|_| report.profile(&entry.origin, "values").is_none());
        let own: Vec<_> = own.map(|meaning| (Value::Integer(meaning.value), "values")).collect();
        let triggers = entry.trigger.iter().map(|trigger| (trigger.value.clone(), "trigger.value"));
        judge(limits, own.into_iter().chain(triggers), &entry.origin, lookup::name(object, entry), report);
    }
    for parameter in &device.parameters {
        let limits = [&parameter.min, &parameter.max].map(Option::as_ref);
        let ends = parameter.values.iter().flat_map(|range| [range.first, range.last]);
        let values = ends.map(|value| (Value::Integer(value), "values"));
        judge(limits, values, &parameter.origin, Section::Parameters.at(&parameter.id), report);
    }
}

/// Reports the first of the values that lies outside of the least and the greatest.
fn judge(
    [min, max]: [Option<&Value>; 2],
    mut values: impl Iterator<Item = (Value, &'static str)>,
    origin: &Origin,
    name: Place,
    report: &mut Report,
) {
    let limits = [(min, "min"), (max, "max")];
    let found = values.find_map(|(value, key)| Some((lookup::beyond(&value, limits)?, value, key)));
    let Some(((limit, side, limit_key), value, key)) = found else { return };
    let message = format!("{name} is never {value}, which is {side} its limit {limit}");
    let diagnostic = Diagnostic::new(&RULE, message, origin.value(key), format!("{value} is here"));
    report.push(name, diagnostic.label(origin.value(limit_key), "the limit"));
}
