use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Entry, Object};

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
        if let Some(diagnostic) = judge(object, entry) {
            report.push(lookup::name(object, entry), diagnostic);
        }
    }
}

fn judge(object: &Object, entry: &Entry) -> Option<Diagnostic> {
    let default = entry.default.as_ref()?;
    let low = entry.min.as_ref().filter(|min| lookup::above(min, default)).map(|min| (min, "below", "min"));
    let high = entry.max.as_ref().filter(|max| lookup::above(default, max)).map(|max| (max, "above", "max"));
    let (limit, side, key) = low.or(high)?;
    let name = lookup::name(object, entry);
    let message = format!("{name} is {default} by default, {side} its limit {limit}");
    let at = entry.origin.value("default");
    let diagnostic = Diagnostic::new(&RULE, message, at, format!("{side} {limit}"));
    Some(diagnostic.label(entry.origin.value(key), "the limit"))
}
