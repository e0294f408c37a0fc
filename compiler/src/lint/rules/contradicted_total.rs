use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// Where a manual gives the length of a PDO, its entries have to add up to that. If they do not, an entry is
    /// missing, too many, or of another width, or the sum is wrong.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// total = 4
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// total = 2
    /// ```
    pub(super) static RULE = "contradicted-total", ProcessData, Warning,
        "the entries of a PDO do not add up to its length";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pdo in &device.pdos {
        let (Some(says), holds) = (pdo.total, pdo.bytes()) else { continue };
        if u32::from(says) == holds {
            continue;
        }
        let message = format!("{} is said to have {says} bytes, but its entries make {holds}", pdo.index);
        let bits = pdo.entries.iter().map(|entry| entry.bits.to_string()).collect::<Vec<_>>().join(" + ");
        let at = pdo.origin.value("total");
        let diagnostic = Diagnostic::new(&RULE, message, at, format!("{says} bytes"))
            .label(pdo.origin.value("entries"), format!("{bits} bits, {holds} bytes"));
        report.push(pdo.index, diagnostic);
    }
}
