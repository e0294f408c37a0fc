use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};
use crate::source::Value;

rule! {
    /// An enumeration that no entry names says nothing: the values that it was meant for have no meaning.
    ///
    /// ## Fires
    /// ```toml
    /// [enumerations.inputs]
    /// values = { 0 = "none", 1 = "servo on" }
    ///
    /// [objects.0x2000]
    /// name = "Function of input 1"
    /// type = "UINT16"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [enumerations.inputs]
    /// values = { 0 = "none", 1 = "servo on" }
    ///
    /// [objects.0x2000]
    /// name = "Function of input 1"
    /// type = "UINT16"
    /// values = "inputs"
    /// ```
    pub(super) static RULE = "idle-enumeration", Values, Warning, "no entry names an enumeration";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let entries = device.objects.iter().flat_map(|object| &object.entries);
    let named = entries.filter_map(|entry| match &entry.origin.node("values")?.value {
        Value::String(name) => Some(&**name),
        _ => None,
    });
    let named: BTreeSet<&str> = named.collect();
    for enumeration in device.enumerations.iter().filter(|known| !named.contains(&*known.id)) {
        let message = format!("no entry names the enumeration `{}`", enumeration.id);
        let diagnostic = Diagnostic::new(&RULE, message, enumeration.origin.header(), "not used")
            .help(format!("write `values = \"{}\"` where values mean that, or take it out", enumeration.id));
        report.push(Section::Enumerations.at(&enumeration.id), diagnostic);
    }
}
