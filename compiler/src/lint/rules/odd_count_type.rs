use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device};

rule! {
    /// Subindex 0 of a record or an array is a byte, whatever the type of the entries: with complete access a
    /// master expects the first entry right behind it.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    /// type = "INT32"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { type = "INT32" }
    /// 1 = { name = "Proportional" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    /// type = "INT32"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { type = "UINT8" }
    /// 1 = { name = "Proportional" }
    /// ```
    pub(super) static RULE = "odd-count-type", Dictionary, Warning, "subindex 0 is not a UINT8";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let is_count = entry.address.subindex == 0 && object.entries.len() > 1;
        if !is_count || matches!(entry.data_type, DataType::Uint(8) | DataType::Bitstring(8)) {
            continue;
        }
        let message = format!("{} is {}, but subindex 0 is always UINT8", entry.address, entry.data_type);
        let at = entry.origin.value("type");
        let diagnostic = Diagnostic::new(&RULE, message, at, "not UINT8")
            .note("ETG.1000.6 gives the number of entries one byte")
            .suggest("make it a byte", at, "\"UINT8\"");
        report.push(entry.address, diagnostic);
    }
}
