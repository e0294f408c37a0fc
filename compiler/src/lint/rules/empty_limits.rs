use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Entry, Place, Value};

rule! {
    /// The position range limit 0x607B and the software position limit 0x607D are pairs: a drive moves between the first and
    /// the second. If both are the same by default there is no room between them. Either they are not in force so, which a
    /// master has to know, or they have to be written before the drive moves.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x607D]
    /// name = "Software position limit"
    /// type = "INT32"
    /// access = "rw"
    /// entries = { 1 = { name = "Min", default = 0 }, 2 = { name = "Max", default = 0 } }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x607D]
    /// name = "Software position limit"
    /// type = "INT32"
    /// access = "rw"
    /// entries = { 1 = { name = "Min", default = -1000 }, 2 = { name = "Max", default = 1000 } }
    /// ```
    pub(super) static RULE = "empty-limits", Dictionary, Warning,
        "a pair of position limits leaves no room between them";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let pairs = lookup::on_axes(device, 0x607B).chain(lookup::on_axes(device, 0x607D));
    for object in pairs.filter(|object| object.functional) {
        let limit = |subindex| object.entry(subindex).filter(|entry| entry.default.is_some());
        let Some((least, greatest)) = limit(1).zip(limit(2)) else { continue };
        let number = |entry: &Entry| entry.default.as_ref().and_then(Value::integer);
        let Some(both) = number(least).filter(|both| number(greatest) == Some(*both)) else { continue };
        let message = format!("{} is {both} and {both} by default", object.index);
        let diagnostic =
            Diagnostic::new(&RULE, message, greatest.origin.value("default"), "nothing lies between")
                .label(least.origin.value("default"), "the other limit")
                .help("if that means that there is no limit, an erratum says so");
        report.push(Place::from(object.index), diagnostic);
    }
}
