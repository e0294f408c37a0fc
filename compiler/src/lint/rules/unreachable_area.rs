use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, SyncManager};

rule! {
    /// The memory of an EtherCAT slave controller begins at 0x1000 and ends at 0xFFFF at the latest; below lie its
    /// registers (ETG.1000.4). Mail or process data cannot lie elsewhere.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// outputs = { address = 0x0F80, max-size = 64 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// outputs = { address = 0x1000, max-size = 64 }
    /// ```
    pub(super) static RULE = "unreachable-area", ProcessData, Warning,
        "a sync manager does not lie in the memory of the controller";
}

/// The registers end here, and the memory begins.
const FIRST: u16 = 0x1000;

pub(super) fn check(device: &Device, report: &mut Report) {
    // one that is off and carries nothing lies nowhere: its address is 0
    let lies = |manager: &&SyncManager| manager.enable || manager.longest() > 0 || manager.address > 0;
    for manager in device.sync_managers.iter().filter(lies) {
        let end = manager.end();
        let fault = match manager.address {
            address if address < FIRST => "the registers lie below 0x1000",
            _ if end > 0x1_0000 => "the memory ends at 0xFFFF",
            _ => continue,
        };
        let (address, buffers) = (manager.address, manager.buffers());
        let message = format!(
            "`{}` lies at 0x{address:04X} to 0x{:04X}, but {fault}",
            manager.id,
            end.max(u32::from(address) + 1) - 1
        );
        let label = format!("{buffers} × {} bytes from here", manager.longest());
        let diagnostic = Diagnostic::new(&RULE, message, manager.origin.value("address"), label);
        report.push(Section::SyncManagers.at(&manager.id), diagnostic);
    }
}
