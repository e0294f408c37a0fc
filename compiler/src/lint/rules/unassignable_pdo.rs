use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Index, Role};

rule! {
    /// Where no master may write the assignment, process data is what the sync managers carry by default, and what a way to
    /// keep time or a configuration names instead. A PDO that is nowhere among that is never transferred: it was forgotten there,
    /// or it is the master who may assign it.
    ///
    /// What is there for a master's own programs only, `virtual`, is not asked.
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
    /// [mailbox]
    /// protocols = ["FoE"]
    ///
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1100
    /// pdos = ["0x1A00"]
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
    /// [mailbox]
    /// protocols = ["FoE"]
    ///
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1100
    /// pdos = ["0x1A00", "0x1A01"]
    /// ```
    pub(super) static RULE = "unassignable-pdo", ProcessData, Warning, "a PDO can never be assigned";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    // a mailbox that is not described may let masters do it
    let Some(mailbox) = device.mailbox.as_ref().filter(|mailbox| !mailbox.pdo_assign) else { return };
    let carried = carried(device);
    for pdo in device.pdos.iter().filter(|pdo| !pdo.r#virtual && !carried.contains(&pdo.index)) {
        let Some(manager) = device.sync_manager(Role::of(pdo.direction)) else { continue };
        let message = format!("{} is assigned by nothing, and no master may assign it", pdo.index);
        let diagnostic = Diagnostic::new(&RULE, message, pdo.origin.header(), "never transferred")
            .label(manager.origin.value("pdos"), "not among these")
            .label(mailbox.origin.value("pdo-assign"), "without `pdo-assign = true`")
            .help("name it where it is assigned, or say that masters may assign it");
        report.push(pdo.index, diagnostic);
    }
}

/// The PDOs that are assigned by anything.
fn carried(device: &Device) -> BTreeSet<Index> {
    let by_default = device.sync_managers.iter().flat_map(|manager| &manager.pdos);
    let managers = device.sync_modes.iter().flat_map(|mode| mode.managers.iter());
    let in_modes = managers.flat_map(|manager| &manager.pdos).map(|it| it.pdo);
    let configurations = device.configurations.iter();
    let chosen = configurations.flat_map(|it| it.outputs.iter().chain(&it.inputs).flatten());
    by_default.chain(chosen).copied().chain(in_modes).collect()
}
