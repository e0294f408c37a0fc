use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, images};
use crate::model::Device;

rule! {
    /// A sync manager takes so many PDOs, the subindices of its assignment object. A master that assigns more is refused.
    ///
    /// ## Fires
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "UINT16", pdo = "tx" }
    /// 0x2001 = { name = "Torque", type = "UINT16", pdo = "tx" }
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    /// slots = 1
    ///
    /// [configurations.both]
    /// name = "Both"
    /// inputs = ["0x1A00", "0x1A01"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "UINT16", pdo = "tx" }
    /// 0x2001 = { name = "Torque", type = "UINT16", pdo = "tx" }
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    /// slots = 1
    ///
    /// [configurations.both]
    /// name = "Both"
    /// inputs = ["0x1A01"]
    /// ```
    pub(super) static RULE = "overfull-assignment", ProcessData, Error,
        "more PDOs are assigned than there can be";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for image in images::images(device) {
        let (Some(manager), Some(assigned)) = (image.manager, image.assigned()) else { continue };
        let count = image.pdos.len();
        if !manager.origin.has("slots") || count <= usize::from(manager.slots) {
            continue;
        }
        let message =
            format!("{count} PDOs are assigned to `{}`, which takes {}", manager.role.key(), manager.slots);
        let diagnostic = Diagnostic::new(&RULE, message, assigned, format!("{count} PDOs"));
        report.push(image.place(), diagnostic.label(manager.origin.value("slots"), "as many as it takes"));
    }
}
