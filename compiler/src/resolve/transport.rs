//! Sync managers, mailbox, EEPROM.

use super::context::Context;
use super::{facts, names, pdos};
use crate::model::{Eeprom, Index, Mailbox, Pdo, Role, SyncManager};
use crate::raw::{Entity, RawEeprom, RawMailbox, RawPdo, RawSyncManager};

/// The sync managers by number.
pub(super) fn sync_managers(
    context: &mut Context<'_>,
    raw: Vec<Entity<RawSyncManager>>,
    described: &[&Entity<RawPdo>],
    pdos: &[Pdo],
) -> Vec<SyncManager> {
    let mut managers = Vec::new();
    for entity in raw {
        let roles = Role::ALL.map(|role| role.key().to_owned());
        let at = entity.origin.header();
        let bound = context.bind(&entity.key, &roles, "sync manager", at);
        let role = bound.and_then(|key| Role::ALL.into_iter().find(|role| role.key() == key));
        if let Some(role) = role {
            managers.push(sync_manager(context, entity, role, described, pdos));
        }
    }
    managers.sort_by_key(|manager| manager.role);
    managers
}

fn sync_manager(
    context: &mut Context<'_>,
    entity: Entity<RawSyncManager>,
    role: Role,
    described: &[&Entity<RawPdo>],
    pdos: &[Pdo],
) -> SyncManager {
    let assigned = assigned(context, &entity, described);
    let bits: u32 = pdos.iter().filter(|pdo| assigned.contains(&pdo.index)).map(Pdo::bits).sum();
    let image = u16::try_from(bits.div_ceil(8)).unwrap_or(u16::MAX);
    let Entity { raw, facts, origin, .. } = entity;
    SyncManager {
        role,
        address: raw.address,
        size: raw.size.unwrap_or(image),
        max_size: raw.max_size,
        control: raw.control.unwrap_or(usual_control(role)),
        slots: raw.slots.unwrap_or_else(|| u8::try_from(assigned.len()).unwrap_or(u8::MAX)),
        pdos: assigned,
        source: facts::source(context, &facts),
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
fn assigned(
    context: &mut Context<'_>,
    entity: &Entity<RawSyncManager>,
    described: &[&Entity<RawPdo>],
) -> Vec<Index> {
    let mut assigned: Vec<(Option<u8>, Index)> = Vec::new();
    for (i, text) in entity.raw.pdos.iter().enumerate() {
        let pdo = described.iter().find(|pdo| names::index(&pdo.key) == names::index(text));
        match (pdo, names::index(text)) {
            (Some(pdo), Some(index)) => assigned.extend(pdos::copies(context, pdo, index)),
            _ => context.no_pdo(text, entity.origin.value(&format!("pdos.{i}")), "not described"),
        }
    }
    assigned.sort_by_key(|(axis, _)| *axis);
    assigned.into_iter().map(|(_, index)| index).collect()
}

/// What the mailbox can do.
pub(super) fn mailbox(context: &Context<'_>, entity: Entity<RawMailbox>) -> Mailbox {
    let Entity { raw, facts, origin, .. } = entity;
    Mailbox {
        protocols: raw.protocols,
        sdo_info: raw.sdo_info,
        pdo_assign: raw.pdo_assign,
        pdo_config: raw.pdo_config,
        complete_access: raw.complete_access,
        segmented: raw.segmented,
        source: facts::source(context, &facts),
        origin,
    }
}

/// The EEPROM, of the usual size if nothing is said.
pub(super) fn eeprom(raw: Option<Entity<RawEeprom>>) -> Eeprom {
    let raw = raw.map(|entity| entity.raw).unwrap_or_default();
    Eeprom { size: raw.size.unwrap_or(2048), config_data: raw.config_data.map_or_else(Vec::new, |hex| hex.0) }
}
