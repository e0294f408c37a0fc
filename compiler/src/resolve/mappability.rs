//! What of the dictionary can be in process data, where the description does not say it.

use std::collections::BTreeSet;

use crate::model::{Address, Direction, Entry, Mappable, Object, Pdo};
use crate::source::Layer;

/// Settles what entries can be mapped. What a profile says holds for the drives of all vendors: where no mapping can be
/// changed, what no PDO carries cannot be mapped, and what one carries can; and what is written in other states than
/// Operational only is no set value.
pub(super) fn settle(objects: &mut [Object], pdos: &[Pdo]) {
    let is_fixed = !pdos.is_empty() && pdos.iter().all(|pdo| pdo.fixed);
    let carried = pdos
        .iter()
        .flat_map(|pdo| pdo.entries.iter().filter_map(|mapped| Some((pdo.direction, mapped.address?))));
    let carried: BTreeSet<(Direction, Address)> = carried.collect();
    for entry in objects.iter_mut().filter(|object| !object.derived).flat_map(|object| &mut object.entries) {
        let from_profile = match entry.origin.layer("pdo") {
            None => false,
            Some(Layer::Profile) => true,
            Some(_) => continue,
        };
        let can = |direction| {
            let is_carried = carried.contains(&(direction, entry.address));
            let is_possible = !is_fixed || is_carried;
            let is_meant = entry.pdo.goes(direction) || is_fixed && !from_profile;
            is_meant && is_possible && (direction == Direction::Tx || may_be_sent(entry))
        };
        entry.pdo = Mappable::of(can(Direction::Rx), can(Direction::Tx));
    }
}

/// Whether a master may write it where it sends process data.
fn may_be_sent(entry: &Entry) -> bool {
    entry.written.is_none_or(|window| window.states()[2])
}
