//! Where the sync managers of a device lie, and how long they may be.

use devc::model::{Device, Role, SyncManager};
use devc_runtime::esm::{Area, Areas};

/// The areas that a master has to set.
pub(super) fn areas(device: &Device) -> Areas {
    let mailbox = |role| device.sync_manager(role).map(mailbox);
    let process_data = |role| device.sync_manager(role).map(|manager| process_data(device, manager));
    let boot = device.eeprom.boot_mailbox();
    let boot = boot.map(|areas| areas.map(|(address, size)| Area { address, length: (size, size) }));
    Areas {
        mailbox_out: mailbox(Role::MailboxOut),
        mailbox_in: mailbox(Role::MailboxIn),
        boot_out: boot.map(|[out, _]| out),
        boot_in: boot.map(|[_, into]| into),
        outputs: process_data(Role::Outputs),
        inputs: process_data(Role::Inputs),
    }
}

/// The numbers of the sync managers by their roles; one beyond all for a role that there is not.
pub(super) fn numbers(device: &Device) -> [usize; 4] {
    let number = |role| device.sync_manager(role).map_or(usize::MAX, |manager| manager.number.into());
    [Role::MailboxOut, Role::MailboxIn, Role::Outputs, Role::Inputs].map(number)
}

/// A mailbox may be set to other sizes only if the description says between which.
fn mailbox(manager: &SyncManager) -> Area {
    let least = manager.min_size.unwrap_or(manager.size);
    Area { address: manager.address, length: (least, manager.max_size.unwrap_or(manager.size)) }
}

/// The end of the memory that most controllers have (ETG.1000.4, process data memory of 8 KB).
const END: u16 = 0x3000;

/// Process data is as long as what is mapped, up to what the sync manager carries; where that is not said, up to where the
/// next one begins.
fn process_data(device: &Device, manager: &SyncManager) -> Area {
    let next =
        device.sync_managers.iter().map(|other| other.address).filter(|next| *next > manager.address).min();
    let room = next.unwrap_or(END).saturating_sub(manager.address) / 3;
    Area { address: manager.address, length: (1, manager.max_size.unwrap_or(room.max(manager.size))) }
}
