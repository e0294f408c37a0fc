use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Role, Section, SyncManager};

rule! {
    /// The control byte of a sync manager says in bits what its role says in a word (ETG.1000.4): bits 0 and 1 how many
    /// buffers there are, 0 for three and 2 for one, bits 2 and 3 who writes, 0 for the device and 1 for the master.
    /// A mailbox has one buffer, since no mail may be lost; bit 6 watches over what the master writes. Bit 7 and the
    /// other patterns are reserved.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128, control = 0x24 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128, control = 0x26 }
    /// ```
    pub(super) static RULE = "contradicted-control", ProcessData, Warning,
        "the control byte of a sync manager does not fit what it is for";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for manager in &device.sync_managers {
        let wrong = faults(manager);
        if !wrong.is_empty() {
            let message = format!(
                "control byte 0x{:02X} does not fit `{}`: {}",
                manager.control,
                manager.role.key(),
                wrong.join("; ")
            );
            let label = format!("0x{:02X} would be usual", manager.role.usual_control());
            let diagnostic = Diagnostic::new(&RULE, message, manager.origin.value("control"), label);
            report.push(Section::SyncManagers.at(&manager.id), diagnostic);
        }
    }
}

/// What a control byte says that its role does not.
fn faults(manager: &SyncManager) -> Vec<&'static str> {
    let SyncManager { control, role, .. } = manager;
    let written = role.is_written();
    let buffers = match (control & 0b11, role) {
        (0, Role::MailboxOut | Role::MailboxIn) => {
            Some("bits 0 and 1 ask for three buffers, a mailbox has one")
        }
        (0 | 2, _) => None,
        _ => Some("bits 0 and 1 are 0 for three buffers or 2 for one"),
    };
    let direction = match (control >> 2 & 0b11, written) {
        (0, true) => Some("bits 2 and 3 let the device write what the master sends"),
        (1, false) => Some("bits 2 and 3 let the master write what the device sends"),
        (0 | 1, _) => None,
        _ => Some("bits 2 and 3 are 0 if the device writes or 1 if the master does"),
    };
    let watched = (control & 0x40 != 0 && !written)
        .then_some("bit 6 watches over what the master writes, and it reads this");
    let reserved = (control & 0x80 != 0).then_some("bit 7 is reserved");
    [buffers, direction, watched, reserved].into_iter().flatten().collect()
}
