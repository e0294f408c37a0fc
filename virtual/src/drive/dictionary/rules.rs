//! What a device lets a master make its process data of.

use devc::model::{Device, Direction, Index};
use devc_runtime::pdo::{Carrier, SyncManager};
use devc_runtime::sdo::PdoRules;

use crate::drive::forever;

/// The rules of a device that has process data.
pub(super) fn rules(device: &Device) -> Option<PdoRules> {
    if device.pdos.is_empty() {
        return None;
    }
    let limits = device.pdos.iter().filter_map(|pdo| Some((pdo.index.0, pdo.max_bytes?)));
    Some(PdoRules {
        outputs: manager(device, Direction::Rx),
        inputs: manager(device, Direction::Tx),
        max_bytes: forever::all(limits),
    })
}

fn manager(device: &Device, way: Direction) -> Option<SyncManager> {
    let carried = device.carried(way)?;
    let indices = |indices: Vec<Index>| forever::all(indices.into_iter().map(|index| index.0));
    let carriers = carried.carriers.into_iter();
    let carriers =
        carriers.map(|(assignment, pdos)| Carrier { assignment: assignment.0, pdos: indices(pdos) });
    Some(SyncManager {
        carriers: forever::all(carriers),
        assignable: carried.assignable,
        slots: carried.slots,
        max_size: carried.max_size,
        mandatory: indices(carried.mandatory),
        exclusive: forever::all(carried.exclusive.into_iter().map(|pair| pair.map(|index| index.0))),
    })
}
