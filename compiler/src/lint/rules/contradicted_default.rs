use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Literal, Parameter};
use crate::source::Value;

rule! {
    /// Mapping and assignment objects follow from the PDOs and the sync managers. What a description says of their
    /// values is checked against that; where it differs, the table of objects and that of the process data
    /// disagree. So it is with the default of an object and that of the parameter behind it in `[parameters]`, if both are
    /// in no unit.
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
        "the value of an object is not what else the description makes it";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    derived(device, report);
    parameters(device, report);
}

/// What is described of a value that devc makes.
fn derived(device: &Device, report: &mut Report) {
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

/// The defaults of objects, and of the parameters behind them.
fn parameters(device: &Device, report: &mut Report) {
    let is_alone = |it: &&Parameter| it.symbol.is_none() && !it.has_elements();
    let alone = device.parameters.iter().filter(is_alone);
    let known: BTreeMap<&str, &Parameter> = alone.map(|it| (&*it.id, it)).collect();
    for (object, entry) in lookup::entries(device).filter(|(_, entry)| entry.unit.is_none()) {
        let of_object = object.parameter.as_ref().filter(|_| object.entries.len() == 1);
        let Some(id) = entry.parameter.as_ref().or(of_object) else { continue };
        let Some(parameter) = known.get(&**id) else { continue };
        let Some((own, other)) = entry.default.as_ref().zip(parameter.default.as_ref()) else { continue };
        if !lookup::above(own, other) && !lookup::above(other, own) {
            continue;
        }
        let name = lookup::name(object, entry);
        let message = format!("{name} is {own} by default, but `{id}`, the parameter behind it, {other}");
        let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value("default"), "of the object")
            .label(parameter.origin.value("default"), "of the parameter")
            .help("correct the one that is wrong, or say in which unit each is");
        report.push(name, diagnostic);
    }
}

fn number(value: &Value) -> Option<i128> {
    match value {
        Value::Integer(number) => Some(*number),
        Value::String(text) => Literal::twice(text).map(|(first, _)| first),
        _ => None,
    }
}
