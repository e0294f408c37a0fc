//! The table that finds an entry by its address, and the names beside it.

use std::collections::BTreeMap;

use devc::model::{Entry, Kind};
use devc_runtime::sdo::{DataType, Dictionary, EntryInfo, NONE, Names, ObjectCode, ObjectInfo, Page};

use super::{Home, bytes, rights};
use crate::drive::forever;

/// The objects whose indices have the same high byte, by that byte, with the low bytes of their indices.
fn pages<'h, 'a>(homes: &'h [Home<'a>]) -> BTreeMap<u8, Vec<(u8, &'h Home<'a>)>> {
    let mut pages: BTreeMap<u8, Vec<(u8, &Home<'a>)>> = BTreeMap::new();
    for home in homes {
        let [high, low] = home.object.index.0.to_be_bytes();
        pages.entry(high).or_default().push((low, home));
    }
    pages
}

/// Every entry of a device, to be found by its address.
pub(super) fn dictionary(homes: &[Home<'_>]) -> Dictionary {
    let (mut constants, mut directory) = (Constants::default(), [NONE; 256]);
    let mut rows = Vec::new();
    for ((high, objects), position) in pages(homes).into_iter().zip(0..NONE) {
        if let Some(slot) = directory.get_mut(usize::from(high)) {
            *slot = position;
        }
        rows.push(page(&objects, &mut constants));
    }
    Dictionary {
        directory: forever::value(directory),
        pages: forever::all(rows),
        constants: forever::all(constants.bytes),
    }
}

fn page(objects: &[(u8, &Home<'_>)], constants: &mut Constants) -> Page {
    let first = objects.first().map_or(0, |(low, _)| *low);
    let mut slots = vec![NONE; 256];
    for ((low, _), position) in objects.iter().zip(0..NONE) {
        if let Some(slot) = slots.get_mut(usize::from(low.wrapping_sub(first))) {
            *slot = position;
        }
    }
    let objects = objects.iter().map(|(_, home)| object(home, constants));
    Page { first, axis: 0, slots: forever::all(slots), objects: forever::all(objects) }
}

fn object(home: &Home<'_>, constants: &mut Constants) -> ObjectInfo {
    let code = match home.object.kind {
        Kind::Var => ObjectCode::Variable,
        Kind::Array => ObjectCode::Array,
        Kind::Record => ObjectCode::Record,
    };
    let fixed = home.object.entries.iter().filter(|entry| item(home, entry).is_none());
    let constants = constants.position(fixed.flat_map(bytes).collect());
    let entries = home.object.entries.iter().map(|entry| info(home, entry));
    ObjectInfo { code, axis: 0, field: home.field, entries: forever::all(entries), constants }
}

fn info(home: &Home<'_>, entry: &Entry) -> EntryInfo {
    EntryInfo {
        subindex: entry.address.subindex,
        item: item(home, entry).unwrap_or(EntryInfo::CONSTANT),
        data_type: DataType(entry.data_type.code()),
        bits: u16::try_from(entry.data_type.bits()).unwrap_or(u16::MAX),
        access: rights::access(entry),
    }
}

/// The position of a value among those of its object that can change.
fn item(home: &Home<'_>, entry: &Entry) -> Option<u8> {
    let position = home.kept.iter().position(|kept| kept.address == entry.address)?;
    u8::try_from(position).ok()
}

/// The values that never change, those of all objects in a row.
#[derive(Default)]
struct Constants {
    bytes: Vec<u8>,
    known: BTreeMap<Vec<u8>, u16>,
}

impl Constants {
    /// Where the values of an object are; the same bytes serve for all objects that have them.
    fn position(&mut self, values: Vec<u8>) -> u16 {
        if values.is_empty() {
            return 0;
        }
        *self.known.entry(values).or_insert_with_key(|values| {
            let end = u16::try_from(self.bytes.len()).unwrap_or(u16::MAX);
            self.bytes.extend(values);
            end
        })
    }
}

/// The name of every object and entry.
pub(super) fn names(homes: &[Home<'_>]) -> Names {
    let of_object = |home: &Home<'_>| {
        let entries = home.object.entries.iter().filter(|_| home.object.kind != Kind::Var);
        let names = std::iter::once(&home.object.name).chain(entries.map(|entry| &entry.name));
        names.map(|name| forever::text(name)).collect::<Vec<_>>()
    };
    let pages = pages(homes).into_values();
    Names {
        pages: forever::all(
            pages.map(|page| forever::all(page.iter().flat_map(|(_, home)| of_object(home)))),
        ),
    }
}
