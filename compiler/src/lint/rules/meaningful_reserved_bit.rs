use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Field};
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
        judge(&word.fields, &word.origin, &format!("words.{}", word.id), report);
    }
    for mode in &device.modes {
        for bits in [&mode.control_bits, &mode.status_bits] {
            judge(&bits.fields, &mode.origin, &format!("modes.{}", mode.code), report);
        }
    }
}

fn judge(fields: &[Field], origin: &Origin, section: &str, report: &mut Report) {
    for field in fields.iter().filter(|field| field.reserved) {
        let keys = [
            ("values", !field.values.is_empty()),
            ("rising", field.rising.is_some()),
            ("falling", field.falling.is_some()),
        ];
        let Some((key, _)) = keys.into_iter().find(|(_, given)| *given) else { continue };
        let path = |key: &str| format!("{}.{key}", field.path);
        let message = format!("bit {} is reserved, but has `{key}`", field.low);
        let diagnostic = Diagnostic::new(&RULE, message, origin.value(&path(key)), "says what it does")
            .label(origin.value(&path("reserved")), "says that it does nothing");
        report.push(format!("{section}.{}", field.low), diagnostic);
    }
}
