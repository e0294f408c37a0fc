//! How many entries a mapping object has.

use crate::model::{Direction, Entry, Object, Pdo};

/// How many entries the mapping object of a PDO has room for: what is said; if nothing is, as many as it has if its mapping
/// is fixed, and else everything that can be mapped once, as far as its bytes and those of its sync manager go with the narrowest of that.
pub(super) fn entries(pdo: &Pdo, objects: &[Object], carried: Option<u16>) -> usize {
    let used = pdo.entries.len();
    let usual = || if pdo.fixed { used } else { fitting(pdo, objects, carried) };
    let takes = pdo.max_entries.map_or_else(usual, usize::from);
    takes.min(Pdo::ROOM).max(used)
}

fn fitting(pdo: &Pdo, objects: &[Object], carried: Option<u16>) -> usize {
    let widths =
        || mappable(objects, pdo.direction).map(|entry| entry.data_type.bits()).filter(|bits| *bits > 0);
    let bytes = [pdo.max_bytes, carried].into_iter().flatten().min();
    let narrowest = widths().min().unwrap_or(1);
    let room =
        bytes.map_or(Pdo::ROOM, |bytes| usize::from(bytes) * 8 / usize::try_from(narrowest).unwrap_or(1));
    room.min(widths().count())
}

/// What can be in PDOs of a direction.
fn mappable(objects: &[Object], direction: Direction) -> impl Iterator<Item = &Entry> {
    objects.iter().flat_map(|object| &object.entries).filter(move |entry| entry.pdo.goes(direction))
}
