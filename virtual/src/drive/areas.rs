//! Where the sync managers of a device lie, and how long they may be.

use devc::model::{Device, Role, SyncManager};
use devc_runtime::esm::{Area, Areas};

/// The areas that a master has to set. No description has a mailbox for Bootstrap.
pub(super) fn areas(device: &Device) -> Areas {
    let mailbox = |role| device.sync_manager(role).map(mailbox);
    let process_data = |role| device.sync_manager(role).map(process_data);
    Areas {
        mailbox_out: mailbox(Role::MailboxOut),
        mailbox_in: mailbox(Role::MailboxIn),
        boot_out: None,
        boot_in: None,
        outputs: process_data(Role::Outputs),
        inputs: process_data(Role::Inputs),
    }
}

/// A mailbox may be set to other sizes only if the description says between which.
fn mailbox(manager: &SyncManager) -> Area {
    let least = manager.min_size.unwrap_or(manager.size);
    Area { address: manager.address, length: (least, manager.max_size.unwrap_or(manager.size)) }
}

/// Process data is as long as what is mapped, up to what the sync manager carries.
fn process_data(manager: &SyncManager) -> Area {
    Area { address: manager.address, length: (1, manager.max_size.unwrap_or(u16::MAX)) }
}
