use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// A PDO that excludes itself could never be assigned.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// pdo = "rx"
    /// access = "rw"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["0x2000"]
    /// excludes = ["0x1600"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// pdo = "rx"
    /// access = "rw"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["0x2000"]
    /// excludes = ["0x1601"]
    ///
    /// [rx-pdos.0x1601]
    /// name = "Other setpoints"
    /// entries = ["0x2000"]
    /// excludes = ["0x1600"]
    /// ```
    pub(super) static RULE = "pointless-exclusion", ProcessData, Warning,
        "a PDO excludes itself";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pdo in device.pdos.iter().filter(|pdo| pdo.excludes.contains(&pdo.index)) {
        let message = format!("{} excludes itself", pdo.index);
        report.push(pdo.index, Diagnostic::new(&RULE, message, pdo.origin.value("excludes"), "the list"));
    }
}
