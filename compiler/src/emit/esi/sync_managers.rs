//! `Fmmu` and `Sm`: the memory that master and device share.

use super::element::Element;
use super::literal::Hex;
use crate::model::{Device, Role, SyncManager};

/// The mapping units in their usual order: outputs, inputs, and the state of the mailbox. Where there are several of a
/// direction, each names its sync manager.
pub(super) fn fmmus(device: &Device) -> Vec<Element> {
    let units = [(Role::Outputs, "Outputs"), (Role::Inputs, "Inputs"), (Role::MailboxIn, "MBoxState")];
    let of_role = |(role, name): (Role, &'static str)| {
        let several = device.sync_managers_of(role).count() > 1;
        let number = move |manager: &SyncManager| several.then_some(manager.number);
        device.sync_managers_of(role).map(move |it| Element::leaf("Fmmu", name).with_some("Sm", number(it)))
    };
    units.into_iter().flat_map(of_role).collect()
}

/// A sync manager.
pub(super) fn sync_manager(manager: &SyncManager) -> Element {
    Element::leaf("Sm", name(manager.role))
        .with_some("MinSize", manager.min_size)
        .with_some("MaxSize", manager.max_size)
        .with("DefaultSize", manager.size)
        .with("StartAddress", Hex(manager.address))
        .with("ControlByte", Hex(manager.control))
        .with_flag("Enable", manager.enable)
        .with_some("OpOnly", manager.op_only.then_some("1"))
}

fn name(role: Role) -> &'static str {
    match role {
        Role::MailboxOut => "MBoxOut",
        Role::MailboxIn => "MBoxIn",
        Role::Outputs => "Outputs",
        Role::Inputs => "Inputs",
    }
}
