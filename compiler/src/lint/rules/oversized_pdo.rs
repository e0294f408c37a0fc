use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Pdo};

rule! {
    /// A device refuses a mapping that is longer than it can carry.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT64"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// max-bytes = 4
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT64"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// max-bytes = 8
    /// ```
    pub(super) static RULE = "oversized-pdo", ProcessData, Error,
        "a PDO is longer than the device can carry";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pdo in &device.pdos {
        let entries = u32::try_from(pdo.entries.len()).unwrap_or(u32::MAX);
        judge(pdo, "max-bytes", pdo.bytes(), pdo.max_bytes.map(u32::from), "bytes", report);
        judge(pdo, "max-entries", entries, pdo.max_entries.map(u32::from), "entries", report);
    }
}

fn judge(pdo: &Pdo, key: &str, has: u32, max: Option<u32>, what: &str, report: &mut Report) {
    if let Some(max) = max.filter(|max| has > *max) {
        let message = format!("{} has {has} {what}, but the device takes {max}", pdo.index);
        let diagnostic =
            Diagnostic::new(&RULE, message, pdo.origin.value("entries"), format!("{has} {what}"))
                .label(pdo.origin.value(key), "the limit");
        report.push(pdo.index, diagnostic);
    }
}
