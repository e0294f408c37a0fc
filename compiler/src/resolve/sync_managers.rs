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
        if let Some(role) = role(context, &entity) {
            let number = entity.number;
            managers.push((number, sync_manager(context, entity, role, described, pdos)));
        }
    }
    let mut managers = in_order(managers);
    (0..=u8::MAX).zip(&mut managers).for_each(|(number, manager)| manager.number = number);
    managers
}

/// What a sync manager is for: what it says, or its key.
fn role(context: &mut Context<'_>, entity: &RawSyncManager) -> Option<Role> {
    let roles = Role::ALL.map(|role| role.key().to_owned());
    let find = |text: &str| Role::ALL.into_iter().find(|role| role.key() == text);
    match &entity.role {
        Some(text) => {
            let at = entity.origin.value("role");
            if find(text).is_some() && find(&entity.key).is_some_and(|key| Some(key) != find(text)) {
                context.invalid(text, &format!("`{}`, as its key says", entity.key), at);
            }
            context.bind(text, &roles, "role", at);
            find(text)
        }
        None => {
            context.bind_key(&entity.key, &roles, "sync manager", entity.origin.header());
            find(&entity.key)
        }
    }
}

/// The sync managers in the order of their numbers; those without one fill the places between, by role.
fn in_order(managers: Vec<(Option<u8>, SyncManager)>) -> Vec<SyncManager> {
    let count = managers.len();
    let (mut placed, mut free): (Vec<_>, Vec<_>) =
        managers.into_iter().partition(|(number, _)| number.is_some());
    placed.sort_by_key(|(number, _)| *number);
    free.sort_by_key(|(_, manager)| manager.role);
    let (mut placed, mut free) = (placed.into_iter().peekable(), free.into_iter());
    let next = |place: usize| {
        let due = placed.next_if(|(number, _)| number.is_some_and(|number| usize::from(number) <= place));
        due.or_else(|| free.next()).or_else(|| placed.next())
    };
    (0..count).filter_map(next).map(|(_, manager)| manager).collect()
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
    #[rustfmt::skip] // a line for what belongs together
    let RawSyncManager {
        key: id, role: _, number: _, address, size, min_size, max_size, control, enable, op_only, r#virtual, pdos: _, slots,
        source, origin,
    } = entity;
    let size = size.unwrap_or(image);
    SyncManager {
        id,
        number: 0,
        role,
        address,
        min_size,
        size,
        max_size,
        control: control.unwrap_or(role.usual_control()),
        enable: enable.unwrap_or(size > 0),
        op_only,
        r#virtual,
        slots: slots.unwrap_or_else(|| u8::try_from(assigned.len()).unwrap_or(u8::MAX)),
        pdos: assigned,
        source,
        origin,
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
            _ => {
                let at = entity.origin.value(&format!("pdos.{i}"));
                context.no_described_pdo(text, at, "not described");
            }
        }
    }
    if assigned.len() > Pdo::ROOM {
        let message = format!("{} PDOs cannot be assigned to one sync manager", assigned.len());
        let label = format!("an assignment holds {}", Pdo::ROOM);
        context.fault(&faults::UNFIT_VALUE, message, entity.origin.value("pdos"), &label);
    }
    assigned.sort_by_key(|(axis, _)| *axis);
    assigned.into_iter().map(|(_, index)| index).collect()
}
