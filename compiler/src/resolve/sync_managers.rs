//! Sync managers.

use super::context::Context;
use super::{names, pdos};
use crate::diagnostic::faults;
use crate::model::{Index, Pdo, Role, SyncManager};
use crate::raw::{RawPdo, RawSyncManager};

/// The sync managers by number.
pub(super) fn sync_managers(
    context: &mut Context<'_>,
    raw: Vec<RawSyncManager>,
    described: &[&RawPdo],
    pdos: &[Pdo],
) -> Vec<SyncManager> {
    let mut managers = Vec::new();
    for entity in raw {
        let roles = Role::ALL.map(|role| role.key().to_owned());
        let at = entity.origin.header();
        context.bind(&entity.key, &roles, "sync manager", at);
        let role = Role::ALL.into_iter().find(|role| role.key() == entity.key);
        if let Some(role) = role {
            managers.push(sync_manager(context, entity, role, described, pdos));
        }
    }
    managers.sort_by_key(|manager| manager.role);
    managers
}

fn sync_manager(
    context: &mut Context<'_>,
    entity: RawSyncManager,
    role: Role,
    described: &[&RawPdo],
    pdos: &[Pdo],
) -> SyncManager {
    let assigned = assigned(context, &entity, described);
    let bits: u32 = pdos.iter().filter(|pdo| assigned.contains(&pdo.index)).map(Pdo::bits).sum();
    let image = u16::try_from(bits.div_ceil(8)).unwrap_or(u16::MAX);
    let RawSyncManager { key: _, address, size, max_size, control, pdos: _, slots, source, origin } = entity;
    SyncManager {
        role,
        address,
        size: size.unwrap_or(image),
        max_size,
        control: control.unwrap_or(usual_control(role)),
        slots: slots.unwrap_or_else(|| u8::try_from(assigned.len()).unwrap_or(u8::MAX)),
        pdos: assigned,
        source,
        origin,
    }
}

/// The control byte that ETG.1000.4 gives a sync manager of this role.
fn usual_control(role: Role) -> u8 {
    match role {
        Role::MailboxOut => 0x26,
        Role::MailboxIn => 0x22,
        Role::Outputs => 0x64,
        Role::Inputs => 0x20,
    }
}

/// The PDOs assigned at start-up, axis after axis.
fn assigned(context: &mut Context<'_>, entity: &RawSyncManager, described: &[&RawPdo]) -> Vec<Index> {
    let mut assigned: Vec<(Option<u8>, Index)> = Vec::new();
    for (i, text) in entity.pdos.iter().enumerate() {
        let index = names::index(text);
        let pdo = described.iter().find(|pdo| names::index(&pdo.key) == index);
        match (pdo, index) {
            (Some(pdo), Some(index)) => assigned.extend(pdos::copies(context, pdo, index)),
            _ => context.no_pdo(text, entity.origin.value(&format!("pdos.{i}")), "not described"),
        }
    }
    if assigned.len() > pdos::MOST {
        let message = format!("{} PDOs cannot be assigned to one sync manager", assigned.len());
        let label = format!("an assignment holds {}", pdos::MOST);
        context.fault(&faults::UNFIT_VALUE, message, entity.origin.value("pdos"), &label);
    }
    assigned.sort_by_key(|(axis, _)| *axis);
    assigned.into_iter().map(|(_, index)| index).collect()
}
