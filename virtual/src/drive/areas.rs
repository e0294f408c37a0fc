//! Where the sync managers of a device lie, and how long they may be.

use devc::model::{self, Device, SyncManager};
use devc_runtime::esm::{Area, Areas, Manager, Role};

use super::forever;

/// The areas that a master has to set.
pub(super) fn areas(device: &Device) -> Areas {
    let boot = device.eeprom.boot_mailbox();
    let managers = device.sync_managers.iter().map(|manager| {
        let role = role(manager.role);
        let length =
            if manager.role.is_process_data() { process_data(device, manager) } else { mailbox(manager) };
        Manager::new(role, manager.address, length)
    });
    Areas {
        managers: forever::all(managers),
        boot: boot.map(|areas| areas.map(|(address, size)| Area { address, length: (size, size) })),
    }
}

fn role(role: model::Role) -> Role {
    match role {
        model::Role::MailboxOut => Role::MailboxOut,
        model::Role::MailboxIn => Role::MailboxIn,
        model::Role::Outputs => Role::Outputs,
        model::Role::Inputs => Role::Inputs,
    }
}

/// A mailbox may be set to other sizes only if the description says between which.
fn mailbox(manager: &SyncManager) -> (u16, u16) {
    (manager.min_size.unwrap_or(manager.size), manager.max_size.unwrap_or(manager.size))
}

/// The end of the memory that most controllers have (ETG.1000.4, process data memory of 8 KB).
const END: u16 = 0x3000;

/// Process data is as long as what is mapped, up to what the sync manager carries; where that is not said, up to where the
/// next one begins.
fn process_data(device: &Device, manager: &SyncManager) -> (u16, u16) {
    let next =
        device.sync_managers.iter().map(|other| other.address).filter(|next| *next > manager.address).min();
    let room = next.unwrap_or(END).saturating_sub(manager.address) / 3;
    (1, manager.max_size.unwrap_or(room.max(manager.size)))
}
