use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::refusal::refusal;
use crate::model::{Device, Section};

rule! {
    /// A procedure is followed by people and by programs. A step that writes what the dictionary does not let anybody write,
    /// or a value that it does not take, ends there.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Temperature"
    /// type = "INT16"
    /// access = "ro"
    ///
    /// [procedures.cool]
    /// name = "Cool down"
    /// steps = [{ do = "Ask for 20 degrees.", object = "0x2000", write = 20 }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Temperature"
    /// type = "INT16"
    /// access = "rw"
    ///
    /// [procedures.cool]
    /// name = "Cool down"
    /// steps = [{ do = "Ask for 20 degrees.", object = "0x2000", write = 20 }]
    /// ```
    pub(super) static RULE = "refused-step", Dictionary, Warning,
        "a step of a procedure writes what the device does not take";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for procedure in &device.procedures {
        for (i, step) in procedure.steps.iter().enumerate() {
            let Some((address, value)) = step.address.zip(step.write.as_ref()) else { continue };
            let Some(entry) = device.entry(address) else { continue };
            let Some(refusal) = refusal(entry, value, None) else { continue };
            let path = format!("steps.{i}");
            let message = format!("{value} is written to {address}, which {}", refusal.comes);
            let at = procedure.origin.value(&format!("{path}.write"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "written here")
                .label(entry.origin.value(refusal.key), refusal.why)
                .help("correct the step, or what the object says");
            report.push(Section::Procedures.at(&procedure.id).at(path), diagnostic);
        }
    }
}
