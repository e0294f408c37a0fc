use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// PDOs that exclude each other cannot be assigned together. If the default assignment does so, the device
    /// does not start with the settings that its own ESI file gives a master.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Torque"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], excludes = ["0x1A01"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"], excludes = ["0x1A00"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00", "0x1A01"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Torque"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], excludes = ["0x1A01"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"], excludes = ["0x1A00"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    /// ```
    pub(super) static RULE = "excluded-assignment", ProcessData, Error,
        "PDOs that exclude each other are assigned together";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for manager in &device.sync_managers {
        for pdo in manager.pdos.iter().filter_map(|index| device.pdo(*index)) {
            let Some(other) = pdo.excludes.iter().find(|other| manager.pdos.contains(other)) else {
                continue;
            };
            let message = format!("{} and {other} are assigned together, but exclude each other", pdo.index);
            let diagnostic = Diagnostic::new(&RULE, message, manager.origin.value("pdos"), "assigned together")
                .label(pdo.origin.value("excludes"), format!("{} excludes {other}", pdo.index));
            report.push(Section::SyncManagers.at(manager.role.key()), diagnostic);
        }
    }
}
