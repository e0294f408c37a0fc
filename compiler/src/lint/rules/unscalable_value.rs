use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device};

rule! {
    /// A unit says what a number measures. A truth value, a text and bytes measure nothing; outputs leave the unit out or show
    /// it beside what cannot be converted.
    ///
    /// ## Fires
    /// ```toml
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "rpm"
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "BOOL"
    /// unit = "speed"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [units.speed]
    /// quantity = "velocity"
    /// symbol = "rpm"
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// unit = "speed"
    /// ```
    pub(super) static RULE = "unscalable-value", Values, Warning, "a value that is no number has a unit";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let Some(unit) = entry.unit.as_ref().filter(|_| !is_number(entry.data_type)) else { continue };
        if lookup::is_shared(object, entry, "unit") {
            continue; // it is meant for the numbers among the entries
        }
        let at = lookup::name(object, entry);
        let message = format!("{at} is {}, which is no number of `{unit}`", entry.data_type);
        let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value("unit"), "measures nothing")
            .label(entry.origin.value("type"), "no number")
            .help("take the unit out, or correct the type");
        report.push(at, diagnostic);
    }
}

fn is_number(data_type: DataType) -> bool {
    use DataType::{Bool, Octets, Text, Unicode};
    !matches!(data_type, Bool | Text(_) | Octets(_) | Unicode(_))
}
