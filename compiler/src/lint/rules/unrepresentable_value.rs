use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device, Section};

rule! {
    /// A value that has a meaning but does not fit the type is never seen. Either the type is too narrow or has
    /// the wrong sign, or the value is a misprint.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "State"
    /// type = "UINT8"
    /// values = { -1 = "unknown", 1 = "stopped" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "State"
    /// type = "INT8"
    /// values = { -1 = "unknown", 1 = "stopped" }
    /// ```
    pub(super) static RULE = "unrepresentable-value", Values, Error,
        "a value that has a meaning does not fit its type";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let is_text =
            matches!(entry.data_type, DataType::Text(_) | DataType::Unicode(_) | DataType::Octets(_));
        if let Some(meaning) = entry.values.first().filter(|_| is_text) {
            let name = lookup::name(object, entry);
            let message = format!("{name} is never {}: {} holds no numbers", meaning.value, entry.data_type);
            let at = entry.origin.value("values");
            let diagnostic = Diagnostic::new(&RULE, message, at, "the values of numbers")
                .label(entry.origin.value("type"), "the type");
            report.push(name, diagnostic);
        }
        let Some((low, high)) = entry.data_type.range() else { continue };
        let outside = |value: &i64| !(low..=high).contains(&i128::from(*value));
        let Some(value) = entry.values.iter().map(|meaning| meaning.value).find(outside) else { continue };
        let name = lookup::name(object, entry);
        let message = format!("{name} is never {value}: {} holds {low} to {high}", entry.data_type);
        let diagnostic =
            Diagnostic::new(&RULE, message, entry.origin.value("values"), format!("{value} is here"))
                .label(entry.origin.value("type"), "the type");
        report.push(name, diagnostic);
    }
    for word in &device.words {
        for field in &word.fields {
            let high = 1_i128.checked_shl(field.width().into()).unwrap_or(i128::MAX);
            let outside = |value: &i64| !(0..high).contains(&i128::from(*value));
            let Some(value) = field.values.iter().map(|meaning| meaning.value).find(outside) else {
                continue;
            };
            let width = field.width();
            let bits = if width == 1 { "one bit".to_owned() } else { format!("{width} bits") };
            let message = format!("`{}` is never {value}: it has {bits}", field.name);
            let place = word.origin.value(&(field.path("bits") + ".values"));
            let diagnostic = Diagnostic::new(&RULE, message, place, format!("{value} is here"));
            report.push(Section::Words.at(&word.id).at(field.low), diagnostic);
        }
    }
}
