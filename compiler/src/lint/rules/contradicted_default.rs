use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;
use crate::model::Literal;
use crate::source::Value;

rule! {
    /// Mapping and assignment objects follow from the PDOs and the sync managers. What a description says of their
    /// values is checked against that; where it differs, the table of objects and that of the process data
    /// disagree.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    ///
    /// [objects.0x1C00.entries]
    /// 2 = { default = 1 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    ///
    /// [objects.0x1C00.entries]
    /// 2 = { default = 2 }
    /// ```
    pub(super) static RULE = "contradicted-default", Dictionary, Warning,
        "the value of an object is not what the PDOs and sync managers make it";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for object in device.objects.iter().filter(|object| object.derived) {
        for entry in &object.entries {
            let written = entry.origin.node("default").and_then(|node| number(&node.value));
            let made = entry.default.as_ref().and_then(|value| value.integer());
            if let (Some(written), Some(made)) = (written, made)
                && written != made
            {
                let message =
                    format!("{} is {written} by its default, but {made} by what is described", entry.address);
                let diagnostic =
                    Diagnostic::new(&RULE, message, entry.origin.value("default"), format!("{made} follows"))
                        .note("it follows from `[rx-pdos]`, `[tx-pdos]` and `[sync-managers]`")
                        .help("leave the default out, or mend what it follows from");
                report.push(entry.address, diagnostic);
            }
        }
    }
}

fn number(value: &Value) -> Option<i128> {
    match value {
        Value::Integer(number) => Some(*number),
        Value::String(text) => Literal::twice(text).map(|(first, _)| first),
        _ => None,
    }
}
