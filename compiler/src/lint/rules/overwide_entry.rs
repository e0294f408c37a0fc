use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A mapping object has one byte for the width of what is mapped, in bits: 255 is the most. A longer text or gap
    /// cannot travel in process data in one piece.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Text"
    /// type = "STRING(32)"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Text"
    /// type = "STRING(16)"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(super) static RULE = "overwide-entry", ProcessData, Error, "a mapped value is wider than 255 bits";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device).filter(|(.., mapped)| mapped.bits > 255) {
        let message = format!("{} maps `{}` with {} bits", pdo.index, mapped.name, mapped.bits);
        let diagnostic =
            Diagnostic::new(&RULE, message, mapped.origin.header(), format!("{} bits", mapped.bits))
                .note("ETG.1000.6 has 8 bits for the width in a mapping object")
                .help("take it out of the PDO: a text travels in SDOs");
        report.push(at, diagnostic);
    }
}
