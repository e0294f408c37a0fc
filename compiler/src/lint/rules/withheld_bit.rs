use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};
use crate::source::{Node, Value};

rule! {
    /// A profile gives some bits of its words a meaning that masters rely on. If a device reserves such a bit,
    /// a master that waits for it waits for ever.
    ///
    /// Bits that are the manufacturer's or whose meaning a mode gives are free to be reserved.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6041]
    ///
    /// [words.statusword]
    /// bits.9 = { reserved = true }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6041]
    ///
    /// [words.statusword]
    /// bits.14 = { reserved = true }
    /// ```
    pub(super) static RULE = "withheld-bit", StateMachine, Warning,
        "a bit that the profile gives a meaning is reserved";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for word in &device.words {
        for field in word.fields.iter().filter(|field| field.reserved) {
            let Some(bit) = report.profile(&word.origin, &field.path("bits")) else { continue };
            let Some(meaning) = meaning(bit) else { continue };
            let message =
                format!("bit {} of {} is reserved, but `{meaning}` in the profile", field.low, word.name);
            let at = word.origin.value(&(field.path("bits") + ".reserved"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "reserved here")
                .label(bit.at, "the profile's bit")
                .note("masters of the profile may wait for it");
            report.push(Section::Words.at(&word.id).at(field.low), diagnostic);
        }
    }
}

/// The name that a profile gives a bit, if it is more than a place for someone else's meaning.
fn meaning(node: &Node) -> Option<&str> {
    let name = match &node.value {
        Value::String(name) => name,
        Value::Table(bit) if bit.get("per-mode").is_none() => match &bit.get("name")?.node.value {
            Value::String(name) => name,
            _ => return None,
        },
        _ => return None,
    };
    (!name.starts_with("manufacturer-specific")).then_some(name)
}
