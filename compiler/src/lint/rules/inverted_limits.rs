use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Entry, Place, Section, Value};
use crate::source::{Location, Origin};

rule! {
    /// A least value above the greatest one leaves no value at all. The same holds for the standard objects that
    /// are a pair of limits, 0x607B and 0x607D, by their defaults.
    ///
    /// Limits that are equal are no fault: in a pair of objects they often mean that there is no limit.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gain"
    /// type = "INT16"
    /// access = "rw"
    /// min = 100
    /// max = 10
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gain"
    /// type = "INT16"
    /// access = "rw"
    /// min = 10
    /// max = 100
    /// ```
    pub(super) static RULE = "inverted-limits", Dictionary, Error,
        "the least value is above the greatest";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let least = Limit::new(entry, entry.min.as_ref(), "min");
        let greatest = Limit::new(entry, entry.max.as_ref(), "max");
        judge(least, greatest, &lookup::name(object, entry), report);
    }
    for parameter in &device.parameters {
        let limit = |value, key| Limit::of(&parameter.origin, value, key);
        let (least, greatest) = (limit(parameter.min.as_ref(), "min"), limit(parameter.max.as_ref(), "max"));
        judge(least, greatest, &Section::Parameters.at(&parameter.id), report);
    }
    for object in lookup::on_axes(device, 0x607B).chain(lookup::on_axes(device, 0x607D)) {
        let limit = |subindex| {
            let entry = object.entry(subindex)?;
            Limit::new(entry, entry.default.as_ref(), "default")
        };
        judge(limit(1), limit(2), &object.index.into(), report);
    }
}

/// A limit and where it was written.
struct Limit<'v> {
    value: &'v Value,
    at: Location,
}

impl<'v> Limit<'v> {
    fn new(entry: &Entry, value: Option<&'v Value>, key: &str) -> Option<Self> {
        Self::of(&entry.origin, value, key)
    }

    fn of(origin: &Origin, value: Option<&'v Value>, key: &str) -> Option<Self> {
        Some(Self { value: value?, at: origin.value(key) })
    }
}

fn judge(least: Option<Limit<'_>>, greatest: Option<Limit<'_>>, name: &Place, report: &mut Report) {
    if let (Some(least), Some(greatest)) = (least, greatest)
        && lookup::above(least.value, greatest.value)
    {
        let message = format!("{name} is at least {} and at most {}", least.value, greatest.value);
        let diagnostic = Diagnostic::new(&RULE, message, least.at, "at least this")
            .label(greatest.at, "at most this")
            .help("swap the two if they were mixed up");
        report.push(name.clone(), diagnostic);
    }
}
