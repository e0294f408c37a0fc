//! The names of objects and entries: text that only the SDO information services need.

use super::{Dictionary, ObjectCode, ObjectInfo};
use crate::object::Address;

/// The names of everything in a dictionary. A firmware that does not mention them does not contain them.
#[derive(Debug, Clone, Copy)]
pub struct Names {
    /// For each page of the table, the names of its objects: of a single value its name, of others the name of the
    /// object and then those of its entries.
    pub pages: &'static [&'static [&'static str]],
}

impl Names {
    /// The name of an object; empty if there is none.
    pub fn object(&self, table: &Dictionary, index: u16) -> &'static str {
        self.name(table, index, 0).unwrap_or_default()
    }

    /// The name of an entry; empty if there is none.
    pub fn entry(&self, table: &Dictionary, address: Address) -> &'static str {
        let Some(object) = table.object(address.index) else { return "" };
        let position = object.entries.iter().position(|entry| entry.subindex == address.subindex);
        let place =
            position.map(|position| if is_single(object) { position } else { position.saturating_add(1) });
        place.and_then(|place| self.name(table, address.index, place)).unwrap_or_default()
    }

    /// The name that is so many behind the first of an object.
    fn name(&self, table: &Dictionary, index: u16, place: usize) -> Option<&'static str> {
        let (page, position) = table.position(index)?;
        let before = table.pages.get(page)?.objects.get(..position)?;
        let names = before
            .iter()
            .map(|object| if is_single(object) { 1 } else { object.entries.len().saturating_add(1) });
        let first = names.fold(0, usize::saturating_add);
        self.pages.get(page)?.get(first.saturating_add(place)).copied()
    }
}

fn is_single(object: &ObjectInfo) -> bool {
    object.code == ObjectCode::Variable
}
