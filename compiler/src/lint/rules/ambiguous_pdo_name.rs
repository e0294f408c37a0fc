use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// Configuration tools list PDOs by name, and whoever picks one of two that are called the same guesses.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Values", entries = ["0x2000"] }
    /// 0x1A01 = { name = "Values", entries = ["0x2000"] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Values", entries = ["0x2000"] }
    /// 0x1A01 = { name = "More values", entries = ["0x2000"] }
    /// ```
    pub(super) static RULE = "ambiguous-pdo-name", ProcessData, Warning, "two PDOs have one name";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first = BTreeMap::new();
    for pdo in &device.pdos {
        let key = (pdo.direction, pdo.axis, pdo.name.to_lowercase());
        let Some(other) = first.get(&key) else {
            first.insert(key, pdo);
            continue;
        };
        let message = format!("{} and {} are both called `{}`", other.index, pdo.index, pdo.name);
        let diagnostic = Diagnostic::new(&RULE, message, pdo.origin.value("name"), "the same name")
            .label(other.origin.value("name"), format!("{} has it, too", other.index))
            .help("add a word to one of them that tells them apart");
        report.push(pdo.index, diagnostic);
    }
}
