use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Field, Place, Section};
use crate::source::Origin;

rule! {
    /// A reserved bit has no meaning; one whose values or edges do something is not reserved. Generated code
    /// leaves reserved bits out.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Status"
    /// type = "UINT8"
    ///
    /// [words.status]
    /// object = "0x2000"
    /// bits.0 = { reserved = true, rising = "The drive starts." }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Status"
    /// type = "UINT8"
    ///
    /// [words.status]
    /// object = "0x2000"
    /// bits.0 = { reserved = true, about = "Always 0." }
    /// ```
    pub(super) static RULE = "meaningful-reserved-bit", StateMachine, Warning,
        "a reserved bit does something";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for word in &device.words {
        judge(&word.fields, &word.origin, "bits", &Section::Words.at(&word.id), report);
    }
    for mode in &device.modes {
        for (key, bits) in [("control-bits", &mode.control_bits), ("status-bits", &mode.status_bits)] {
            judge(bits, &mode.origin, key, &Section::Modes.at(mode.code).at(key), report);
        }
    }
}

fn judge(fields: &[Field], origin: &Origin, bits: &str, at: &Place, report: &mut Report) {
    for field in fields.iter().filter(|field| field.reserved) {
        let keys = [
            ("values", !field.values.is_empty()),
            ("rising", field.rising.is_some()),
            ("falling", field.falling.is_some()),
        ];
        let Some((key, _)) = keys.into_iter().find(|(_, given)| *given) else { continue };
        let path = |key: &str| format!("{}.{key}", field.path(bits));
        let message = format!("bit {} is reserved, but has `{key}`", field.low);
        let diagnostic = Diagnostic::new(&RULE, message, origin.value(&path(key)), "says what it does")
            .label(origin.value(&path("reserved")), "says that it does nothing");
        report.push(at.clone().at(field.low), diagnostic);
    }
}
