//! What the values of a dictionary after start-up say of process data: what is mapped, what is assigned, and to which sync
//! manager (ETG.1000.6).

use super::esi::{Device, Mailbox, Object, Pdo, PdoEntry, Sm, Value, Written};
use super::number::number;

/// The object that says what each sync manager is for.
const TYPES: u16 = 0x1C00;

/// The assignment object of the first sync manager.
const ASSIGNMENTS: u16 = 0x1C10;

/// The names of the kinds of sync managers, from 1 on.
const KINDS: [&str; 4] = ["MBoxOut", "MBoxIn", "Outputs", "Inputs"];

/// A device that has a dictionary with CoE, with the PDOs and sync managers that this tells.
pub(super) fn device(objects: Vec<Object>) -> Device {
    let writable =
        |index: u16| find(&objects, index).is_some_and(|object| object.values.iter().any(is_writable));
    let is_mapping = |object: &&Object| matches!(object.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF);
    let maps = objects.iter().filter(is_mapping).any(|object| writable(object.index));
    let mailbox = Mailbox {
        protocols: vec!["CoE".to_owned()],
        acknowledged: true,
        pdo_assign: (ASSIGNMENTS..=0x1C2F).any(writable),
        pdo_config: maps,
        ..Mailbox::default()
    };
    let profile = find(&objects, 0x1000).and_then(|kind| value(kind, 0));
    Device {
        profile: profile.map(|kind| kind & 0xFFFF).filter(|number| *number > 0),
        sync_managers: sync_managers(&objects),
        rx_pdos: pdos(&objects, 0x1600..=0x17FF),
        tx_pdos: pdos(&objects, 0x1A00..=0x1BFF),
        mailbox: Some(mailbox),
        objects,
        ..Device::default()
    }
}

/// Vendor, product code and revision as 0x1018 has them.
pub(super) fn identity(objects: &[Object]) -> [Option<u32>; 3] {
    let identity = find(objects, 0x1018);
    [1, 2, 3].map(|subindex| identity.and_then(|object| value(object, subindex)))
}

fn find(objects: &[Object], index: u16) -> Option<&Object> {
    objects.iter().find(|object| object.index == index)
}

fn is_writable(value: &Value) -> bool {
    value.flags.access.as_deref() == Some("rw")
}

/// The number that an entry has after start-up.
fn value(object: &Object, subindex: u8) -> Option<u32> {
    let entry = object.values.iter().find(|value| value.subindex == subindex)?;
    match &entry.default.as_ref()?.written {
        Written::Number(text) => number(text),
        Written::Data(_) | Written::Text(_) => None,
    }
}

/// As many values as subindex 0 says, if all are known.
fn values(object: &Object) -> Option<Vec<u32>> {
    let count = u8::try_from(value(object, 0)?).ok()?;
    (1..=count).map(|subindex| value(object, subindex)).collect()
}

fn sync_managers(objects: &[Object]) -> Vec<Sm> {
    let Some(kinds) = find(objects, TYPES).and_then(|types| Some((types, values(types)?))) else {
        return Vec::new();
    };
    let (types, kinds) = kinds;
    let named = kinds.into_iter().map_while(|kind| {
        KINDS.get(usize::try_from(kind).ok()?.checked_sub(1)?).map(|name| (*name).to_owned())
    });
    named.map(|name| Sm { at: types.at, name, ..Sm::default() }).collect()
}

/// The PDOs of a direction whose mapping is known.
fn pdos(objects: &[Object], indices: std::ops::RangeInclusive<u16>) -> Vec<Pdo> {
    let mut pdos: Vec<Pdo> = objects
        .iter()
        .filter(|object| indices.contains(&object.index))
        .filter_map(|it| pdo(objects, it))
        .collect();
    // Assigned ones in the order of their assignment, as in the process image.
    pdos.sort_by_key(|pdo| (pdo.sm.is_none(), place(objects, pdo.index)));
    pdos
}

fn pdo(objects: &[Object], object: &Object) -> Option<Pdo> {
    let entries = values(object)?.into_iter().map(|mapped| entry(objects, object, mapped)).collect();
    Some(Pdo {
        at: object.at,
        index: object.index,
        name: object.name.clone(),
        fixed: !object.values.iter().any(is_writable),
        sm: place(objects, object.index).map(|(manager, _)| manager),
        entries,
        ..Pdo::default()
    })
}

/// The sync manager that a PDO is assigned to, and its place there.
fn place(objects: &[Object], index: u16) -> Option<(u8, usize)> {
    (0..=0x1F).find_map(|manager: u8| {
        let assigned = values(find(objects, ASSIGNMENTS + u16::from(manager))?)?;
        assigned.iter().position(|pdo| *pdo == u32::from(index)).map(|place| (manager, place))
    })
}

/// What a mapping object holds of an entry: index, subindex and width.
fn entry(objects: &[Object], object: &Object, mapped: u32) -> PdoEntry {
    let [bits, subindex, low, high] = mapped.to_le_bytes();
    let index = u16::from_le_bytes([low, high]);
    let target = find(objects, index);
    let value = target.and_then(|it| it.values.iter().find(|value| value.subindex == subindex));
    let name = match target.map(|it| it.values.len()) {
        Some(1) => target.and_then(|it| it.name.clone()),
        _ => value.and_then(|value| value.name.clone()),
    };
    PdoEntry {
        at: object.at,
        index,
        subindex,
        bits: bits.into(),
        name,
        data_type: value.map(|value| value.type_name.clone()),
        ..PdoEntry::default()
    }
}
