use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, SyncManager};

rule! {
    /// Process data is as long as the PDOs that are assigned by default, and the device checks that length when it is
    /// started: a size beside it can only say the same. Nor can an area be longer than the longest that it can get, or
    /// shorter than the shortest.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers]
    /// inputs = { address = 0x1100, size = 8, pdos = ["0x1A00"] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers]
    /// inputs = { address = 0x1100, size = 4, max-size = 8, pdos = ["0x1A00"] }
    /// ```
    pub(super) static RULE = "contradicted-size", ProcessData, Warning,
        "the size of a sync manager is not that of what it carries";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for manager in &device.sync_managers {
        if let Some((message, key)) = judge(device, manager) {
            let at = manager.origin.value(key);
            let diagnostic = Diagnostic::new(&RULE, message, at, format!("{} bytes", manager.size));
            report.push(Section::SyncManagers.at(&manager.id), diagnostic);
        }
    }
}

/// What is wrong with the size of a sync manager, and at which key. One that is too short is another rule's.
fn judge(device: &Device, manager: &SyncManager) -> Option<(String, &'static str)> {
    let (id, size) = (&manager.id, manager.size);
    let carried = device.carried_bytes(manager);
    let stated = manager.origin.has("size");
    if stated && manager.role.is_process_data() && u32::from(size) > carried {
        return Some((format!("`{id}` has {size} bytes, but carries {carried} by default"), "size"));
    }
    if let Some(most) = manager.max_size.filter(|most| stated && size > *most) {
        return Some((format!("`{id}` has {size} bytes, but {most} at most"), "size"));
    }
    let least = manager.min_size.filter(|least| size < *least && size > 0)?;
    Some((format!("`{id}` has {size} bytes, but {least} at least"), "min-size"))
}
