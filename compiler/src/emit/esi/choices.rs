//! Choices of PDOs by name. ETG.2000 has no element for them; TwinCAT's stand where tools of vendors find what is their own,
//! and all others pass over them.

use super::element::Element;
use super::literal::Hex;
use crate::model::{Configuration, Device, Direction, Index, Role, SyncManager};

/// `VendorSpecific` with the configurations that choose PDOs and nothing else, if there are several: what one maps or writes
/// besides would stay undone.
pub(super) fn choices(device: &Device) -> Option<Element> {
    let choices: Vec<Element> = device.configurations.iter().filter_map(|it| choice(device, it)).collect();
    (choices.len() > 1)
        .then(|| Element::new("VendorSpecific").child(Element::new("TwinCAT").children(choices)))
}

fn choice(device: &Device, configuration: &Configuration) -> Option<Element> {
    let assigned = [Direction::Rx, Direction::Tx]
        .into_iter()
        .filter_map(|direction| Some((direction, configuration.assigned(direction)?)));
    let assigned = assigned.map(|(direction, pdos)| Some((manager(device, direction)?, pdos)));
    let assigned: Vec<(&SyncManager, &[Index])> = assigned.collect::<Option<_>>()?;
    if assigned.is_empty() || !is_choice_alone(configuration) {
        return None;
    }
    let is_default = assigned.iter().all(|(manager, pdos)| manager.pdos == *pdos);
    let sm = |(manager, pdos): (&SyncManager, &[Index])| {
        let pdos = pdos.iter().map(|index| Element::leaf("Pdo", Hex(index.0)));
        Element::new("Sm").with("No", manager.number).children(pdos)
    };
    Some(
        Element::new("AlternativeSmMapping")
            .with_some("Default", is_default.then_some("1"))
            .child(Element::leaf("Name", &configuration.name))
            .children(assigned.into_iter().map(sm)),
    )
}

/// Whether it has nothing but assignments.
fn is_choice_alone(configuration: &Configuration) -> bool {
    configuration.mapping.is_empty()
        && configuration.writes.is_empty()
        && configuration.mode.is_none()
        && configuration.cycle_time.is_none()
}

/// The sync manager of a direction, if there is one alone.
fn manager(device: &Device, direction: Direction) -> Option<&SyncManager> {
    let mut managers = device.sync_managers_of(Role::of(direction));
    managers.next().filter(|_| managers.next().is_none())
}
