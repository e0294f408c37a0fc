use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// If one PDO excludes another, so does the other the one. A configuration tool looks at the PDO that is
    /// selected; where only one of the two tells of the other, it depends on the order whether both can be chosen.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], excludes = ["0x1A01"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2000"] }
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
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], excludes = ["0x1A01"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2000"], excludes = ["0x1A00"] }
    /// ```
    pub(super) static RULE = "one-sided-exclusion", ProcessData, Warning,
        "a PDO excludes another that does not exclude it";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pdo in &device.pdos {
        for other in pdo.excludes.iter().filter_map(|other| device.pdo(*other)) {
            if other.excludes.contains(&pdo.index) {
                continue;
            }
            let message = format!("{} excludes {}, but not the other way round", pdo.index, other.index);
            let diagnostic =
                Diagnostic::new(&RULE, message, other.origin.value("excludes"), "says nothing of it")
                    .label(pdo.origin.value("excludes"), format!("excludes {}", other.index))
                    .help(format!("add \"{}\" to `excludes` of {}", pdo.index, other.index));
            report.push(other.index, diagnostic);
        }
    }
}
