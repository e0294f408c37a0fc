//! `Fmmu` and `Sm`: the memory that master and device share.

use super::element::Element;
use super::literal::Hex;
use crate::model::{Device, Index, Role, SyncManager};

/// The mapping units. Where there are several of a direction, each names its sync manager.
pub(super) fn fmmus(device: &Device) -> Vec<Element> {
    let unit = |manager: &SyncManager| {
        let name = match manager.role {
            Role::Outputs => "Outputs",
            Role::Inputs => "Inputs",
            Role::MailboxIn | Role::MailboxOut => "MBoxState",
        };
        let several = device.sync_managers_of(manager.role).count() > 1;
        Element::leaf("Fmmu", name)
            .with_some("Sm", several.then_some(manager.number))
            .with_some("Su", sync_unit(device, manager))
    };
    device.mapping_units().map(unit).collect()
}

/// The place of the sync unit of its PDOs, if all are of one.
fn sync_unit(device: &Device, manager: &SyncManager) -> Option<usize> {
    let unit = |index: &Index| device.pdo(*index).and_then(|pdo| pdo.sync_unit.as_deref());
    let first = manager.pdos.first().and_then(unit)?;
    let is_of_one = manager.pdos.iter().all(|index| unit(index) == Some(first));
    device.sync_units().iter().position(|known| *known == first).filter(|_| is_of_one)
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
        .with_some("Virtual", manager.r#virtual.then_some("1"))
}

fn name(role: Role) -> &'static str {
    match role {
        Role::MailboxOut => "MBoxOut",
        Role::MailboxIn => "MBoxIn",
        Role::Outputs => "Outputs",
        Role::Inputs => "Inputs",
    }
}
