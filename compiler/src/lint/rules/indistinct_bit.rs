use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Field, Place, Section};
use crate::source::Origin;

rule! {
    /// Two bits of a word that do the same, word by word, under two names: one of the texts is likely to be a copy that was
    /// not adapted, so that nobody can tell what the bit does.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Control"
    /// type = "UINT16"
    ///
    /// [words.control]
    /// object = "0x2000"
    ///
    /// [words.control.bits]
    /// 4 = { name = "enable ramp", about = "At 0 the set value is 0." }
    /// 6 = { name = "reference ramp", about = "At 0 the set value is 0." }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Control"
    /// type = "UINT16"
    ///
    /// [words.control]
    /// object = "0x2000"
    ///
    /// [words.control.bits]
    /// 4 = { name = "enable ramp", about = "At 0 the set value is 0." }
    /// 6 = { name = "reference ramp", about = "At 0 the ramp's input is 0." }
    /// ```
    pub(super) static RULE = "indistinct-bit", StateMachine, Warning,
        "two bits of a word are described by the same words";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for word in &device.words {
        judge(&word.fields, &word.origin, "bits", &Section::Words.at(&word.id), report);
    }
    for mode in &device.modes {
        for (key, fields) in [("control-bits", &mode.control_bits), ("status-bits", &mode.status_bits)] {
            judge(fields, &mode.origin, key, &Section::Modes.at(mode.code), report);
        }
    }
}

/// Reports each field that says what one before it says.
fn judge(fields: &[Field], origin: &Origin, key: &str, at: &Place, report: &mut Report) {
    for (place, second) in fields.iter().enumerate() {
        let Some(about) = &second.about else { continue };
        let alike = |first: &&Field| first.about.as_ref() == Some(about) && first.name != second.name;
        let Some(first) = fields.iter().take(place).find(alike) else { continue };
        let message = format!("`{}` and `{}` are described by the same words", first.name, second.name);
        let path = second.path(key);
        let of = |field: &Field| format!("{}.about", field.path(key));
        let diagnostic = Diagnostic::new(&RULE, message, origin.value(&of(second)), "again here")
            .label(origin.value(&of(first)), "first here");
        report.push(at.clone().at(path), diagnostic);
    }
}
