use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, images};
use crate::model::{Device, Role};

rule! {
    /// A PDO that cannot be taken out of its sync manager has to be among those that are assigned, by default and in each
    /// configuration; else the device refuses the assignment.
    ///
    /// ## Fires
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "UINT16", pdo = "tx" }
    /// 0x2001 = { name = "Torque", type = "UINT16", pdo = "tx" }
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], mandatory = true }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    /// slots = 2
    ///
    /// [configurations.torque]
    /// name = "Torque"
    /// inputs = ["0x1A01"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "UINT16", pdo = "tx" }
    /// 0x2001 = { name = "Torque", type = "UINT16", pdo = "tx" }
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], mandatory = true }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    /// slots = 2
    ///
    /// [configurations.torque]
    /// name = "Torque"
    /// inputs = ["0x1A00", "0x1A01"]
    /// ```
    pub(super) static RULE = "missing-mandatory-pdo", ProcessData, Error,
        "a PDO is left out that cannot be taken out";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for image in images::images(device) {
        let Some(assigned) = image.assigned() else { continue };
        for pdo in device.pdos.iter().filter(|pdo| pdo.mandatory && Role::of(pdo.direction) == image.role) {
            if image.pdos.iter().any(|other| other.index == pdo.index) {
                continue;
            }
            let message = format!("{} is not assigned, but cannot be taken out", pdo.index);
            let diagnostic = Diagnostic::new(&RULE, message, assigned, "not among these");
            report.push(image.place(), diagnostic.label(pdo.origin.value("mandatory"), "always there"));
        }
    }
}
