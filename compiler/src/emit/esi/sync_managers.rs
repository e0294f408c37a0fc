//! `Fmmu` and `Sm`: the memory that master and device share.

use super::element::Element;
use super::literal::Hex;
use crate::model::{Device, Role, SyncManager};

/// The mapping units in their usual order: outputs, inputs, and the state of the mailbox.
pub(super) fn fmmus(device: &Device) -> Vec<Element> {
    let units = [(Role::Outputs, "Outputs"), (Role::Inputs, "Inputs"), (Role::MailboxIn, "MBoxState")];
    let used = units.into_iter().filter(|(role, _)| device.sync_manager(*role).is_some());
    used.map(|(_, name)| Element::leaf("Fmmu", name)).collect()
}

/// A sync manager; one without data to carry is off.
pub(super) fn sync_manager(manager: &SyncManager) -> Element {
    Element::leaf("Sm", name(manager.role))
        .with_some("MaxSize", manager.max_size)
        .with("DefaultSize", manager.size)
        .with("StartAddress", Hex(manager.address))
        .with("ControlByte", Hex(manager.control))
        .with_flag("Enable", manager.size > 0)
}

fn name(role: Role) -> &'static str {
    match role {
        Role::MailboxOut => "MBoxOut",
        Role::MailboxIn => "MBoxIn",
        Role::Outputs => "Outputs",
        Role::Inputs => "Inputs",
    }
}
