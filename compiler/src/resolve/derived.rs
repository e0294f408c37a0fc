//! Objects that follow from the PDOs and the sync managers.

use super::entries::plain;
use super::objects::Described;
use super::{capacity, overlay};
use crate::model::{
    Access, Address, Category, DataType, Direction, Entry, Index, Kind, Mailbox, Mapped, Object, Pdo, Role,
    SyncManager, Translations, Value, WriteWindow,
};
use crate::raw::RawObject;
use crate::source::Origin;

/// What the derived objects follow from.
pub(super) struct Basis<'a> {
    pub(super) pdos: &'a [Pdo],
    pub(super) sync_managers: &'a [SyncManager],
    pub(super) mailbox: Option<&'a Mailbox>,
    pub(super) origin: &'a Origin,
}

/// The whole dictionary: the described objects, and the derived ones with what is said of them.
pub(super) fn dictionary(
    context: &mut super::context::Context<'_>,
    described: Described,
    basis: &Basis<'_>,
) -> Vec<Object> {
    let Described { mut objects, overlays } = described;
    let mappings: Vec<Object> = basis.pdos.iter().map(|pdo| mapping(pdo, &objects, basis)).collect();
    objects.extend(mappings);
    if !basis.sync_managers.is_empty() {
        objects.push(types(basis));
        objects.extend(basis.sync_managers.iter().filter_map(|manager| assignment(manager, basis)));
    }
    objects.sort_by_key(|object| object.index);
    for overlay in overlays {
        let index = overlay.index;
        let place = match objects.binary_search_by_key(&index, |object| object.index) {
            Ok(place) => place,
            // One of a device without sync managers, and one that is described as a whole, is an object as any other.
            Err(place) if is_whole(&overlay) => {
                let object = super::objects::object(context, &overlay, index, None);
                object.into_iter().for_each(|object| objects.insert(place, object));
                continue;
            }
            Err(place) => {
                objects.insert(place, empty_assignment(index, overlay.origin.clone()));
                place
            }
        };
        if let Some(object) = objects.get_mut(place) {
            overlay::apply(context, object, overlay);
        }
    }
    objects
}

fn object(index: Index, id: String, name: String, entries: Vec<Entry>, origin: &Origin) -> Object {
    Object {
        index,
        leading: index,
        id,
        name,
        names: Translations::default(),
        kind: Kind::Array,
        axis: None,
        category: Category::Mandatory,
        about: None,
        note: None,
        functional: true,
        parameter: None,
        properties: Vec::new(),
        sdo_access: None,
        entries,
        derived: true,
        source: None,
        origin: origin.header_only(),
    }
}

/// Subindex 0 with the number of entries in use, and the entries. What process data is made of can be written in
/// Pre-Operational only, ETG.1020.
fn entries(
    index: Index,
    data_type: DataType,
    used: usize,
    values: impl Iterator<Item = (String, u32)>,
    access: Access,
    origin: &Origin,
) -> Vec<Entry> {
    let mut count = super::entries::count(index, 0, origin);
    count.default = Some(Value::Integer(i64::try_from(used).unwrap_or(i64::MAX)));
    let lets = |entry: &mut Entry| {
        entry.access = access;
        entry.written = Some(WriteWindow::PreOp).filter(|_| access.writable());
    };
    lets(&mut count);
    let numbered = (1..=u8::MAX).zip(values);
    let values = numbered.map(|(subindex, (name, value))| {
        let mut entry = plain(Address { index, subindex }, &name, data_type, origin);
        entry.id = format!("entry-{subindex}");
        entry.default = Some(Value::Integer(value.into()));
        lets(&mut entry);
        entry
    });
    std::iter::once(count).chain(values).collect()
}

/// The mapping object of a PDO. What lies behind a subindex of a free mapping changes, so that it has a number for a name.
fn mapping(pdo: &Pdo, objects: &[Object], basis: &Basis<'_>) -> Object {
    let free = !pdo.fixed && basis.mailbox.is_some_and(|mailbox| mailbox.pdo_config);
    let access = if free { Access::Rw } else { Access::Ro };
    let name = |place, entry: Option<&Mapped>| match entry.filter(|_| pdo.fixed) {
        Some(entry) => entry.name.clone(),
        None => numbered(place),
    };
    let places = 1..=capacity::entries(pdo, objects, carried(pdo.direction, basis));
    let values = places.map(|place| {
        let entry = pdo.entries.get(place - 1);
        (name(place, entry), entry.map_or(0, |entry| entry.mapping().word()))
    });
    let entries = entries(pdo.index, DataType::Uint(32), pdo.entries.len(), values, access, &pdo.origin);
    let kind = match pdo.direction {
        Direction::Rx => "rx",
        Direction::Tx => "tx",
    };
    let id = format!("{kind}-pdo-{:04x}", pdo.index.0);
    let mut object = object(pdo.index, id, pdo.name.clone(), entries, &pdo.origin);
    object.kind = Kind::Record;
    object.axis = pdo.axis;
    object.leading = pdo.leading;
    object.source = pdo.source.clone();
    object
}

/// The longest that a sync manager carries of a direction.
fn carried(direction: Direction, basis: &Basis<'_>) -> Option<u16> {
    let role = Role::of(direction);
    basis.sync_managers.iter().find(|manager| manager.role == role)?.max_size
}

/// The name of a subindex whose value names something else from time to time.
fn numbered(subindex: usize) -> String {
    format!("SubIndex {subindex:03}")
}

/// 0x1C00: what each sync manager is for, as ETG.1000.6 numbers it.
fn types(basis: &Basis<'_>) -> Object {
    let index = Index(0x1C00);
    let values = basis
        .sync_managers
        .iter()
        .map(|manager| (format!("Sync manager {}", manager.number), u32::from(manager.role.kind())));
    let used = basis.sync_managers.len();
    let entries = entries(index, DataType::Uint(8), used, values, Access::Ro, basis.origin);
    let name = "Sync manager communication type";
    object(index, "sync-manager-communication-type".to_owned(), name.to_owned(), entries, basis.origin)
}

/// 0x1C10 and the sync manager's number: the PDOs that it carries, 0x1C12 and 0x1C13 in most devices.
fn assignment(manager: &SyncManager, basis: &Basis<'_>) -> Option<Object> {
    if !manager.role.is_process_data() {
        return None;
    }
    let number = manager.number;
    let index = manager.assignment();
    let free = basis.mailbox.is_some_and(|mailbox| mailbox.pdo_assign);
    let access = if free { Access::Rw } else { Access::Ro };
    let slots = usize::from(manager.slots).max(manager.pdos.len());
    let assigned = manager.pdos.iter().map(|index| u32::from(index.0)).chain(std::iter::repeat(0));
    let values = (1..=slots).zip(assigned).map(|(slot, value)| (numbered(slot), value));
    let used = manager.pdos.len();
    let entries = entries(index, DataType::Uint(16), used, values, access, &manager.origin);
    let id = format!("sync-manager-{number}-pdo-assignment");
    let name = format!("Sync manager {number} PDO assignment");
    let mut object = object(index, id, name, entries, &manager.origin);
    object.source = manager.source.clone();
    Some(object)
}

/// Whether a table says what its object is made of; one of an assignment object need not.
fn is_whole(raw: &RawObject) -> bool {
    raw.index < Index(0x1C10) || raw.entries.iter().any(|entries| entries.range != (0, 0))
}

/// The assignment object of a sync manager that carries no PDOs, which exists only if a description says so.
fn empty_assignment(index: Index, origin: Origin) -> Object {
    let number = index.0 & 0xF;
    let entries = entries(index, DataType::Uint(16), 0, std::iter::empty(), Access::Ro, &origin);
    let id = format!("sync-manager-{number}-pdo-assignment");
    object(index, id, format!("Sync manager {number} PDO assignment"), entries, &origin)
}
