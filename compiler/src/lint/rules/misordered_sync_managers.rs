use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// Sync managers usually lie one behind the other in the order of their numbers: mailbox out, mailbox in,
    /// outputs, inputs. Another order works, but it is mostly two addresses that were mixed up.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1080, size = 128 }
    /// mailbox-in = { address = 0x1000, size = 128 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// ```
    pub(super) static RULE = "misordered-sync-managers", ProcessData, Warning,
        "a sync manager lies before the one of the number below";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pair in device.sync_managers.windows(2) {
        let [before, after] = pair else { continue };
        if before.address <= after.address {
            continue;
        }
        let (first, second) = (before.role.key(), after.role.key());
        let message =
            format!("`{second}` at 0x{:04X} lies before `{first}` at 0x{:04X}", after.address, before.address);
        let diagnostic = Diagnostic::new(&RULE, message, after.origin.value("address"), "before the other")
            .label(before.origin.value("address"), "behind the other");
        report.push(format!("sync-managers.{second}"), diagnostic);
    }
}
