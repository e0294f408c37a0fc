use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Role, Section};

rule! {
    /// What the master sends usually lies before what the device sends, in the mailbox as in process data. Another
    /// order works, but it is mostly two addresses that were mixed up. Which comes first, mailbox or process data,
    /// is a matter of taste.
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
        "what the device sends lies before what the master sends";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pair in [(Role::MailboxOut, Role::MailboxIn), (Role::Outputs, Role::Inputs)] {
        let (Some(before), Some(after)) = (device.sync_manager(pair.0), device.sync_manager(pair.1)) else {
            continue;
        };
        if before.address <= after.address {
            continue;
        }
        let (first, second) = (&before.id, &after.id);
        let message = format!(
            "`{second}` at 0x{:04X} lies before `{first}` at 0x{:04X}",
            after.address, before.address
        );
        let diagnostic = Diagnostic::new(&RULE, message, after.origin.value("address"), "before the other")
            .label(before.origin.value("address"), "behind the other")
            .help("swap the two if they were mixed up");
        report.push(Section::SyncManagers.at(second), diagnostic);
    }
}
