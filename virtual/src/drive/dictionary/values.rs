//! The values of a dictionary that is known only when the program runs.

use devc_runtime::object::Address;
use devc_runtime::sdo::{self, Dictionary, PdoRules, Place, Range, Slot};

use super::Tables;

/// The values of a device, in the place of the struct that generated code has.
#[derive(Debug, Clone)]
pub struct Values {
    tables: &'static Tables,
    /// By field, and there by position.
    kept: Vec<Vec<Kept>>,
}

/// A value as it is kept.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Kept {
    /// One bit.
    Bool(bool),
    /// Whatever has a number of bytes, as it travels.
    Bytes(Vec<u8>),
    /// A text that cannot be written.
    Text(&'static str),
}

impl Values {
    /// The values after start-up.
    pub(crate) fn new(tables: &'static Tables) -> Self {
        Self { tables, kept: tables.defaults.clone() }
    }

    /// The bytes of a value that has a number of them.
    pub(super) fn bytes(&self, place: Place) -> Option<&[u8]> {
        match self.kept.get(usize::from(place.field))?.get(usize::from(place.item))? {
            Kept::Bytes(bytes) => Some(bytes),
            Kept::Bool(_) | Kept::Text(_) => None,
        }
    }

    /// The same, to be written.
    pub(super) fn bytes_mut(&mut self, place: Place) -> Option<&mut [u8]> {
        match self.at(place)? {
            Kept::Bytes(bytes) => Some(bytes),
            Kept::Bool(_) | Kept::Text(_) => None,
        }
    }

    /// The value of an entry that is kept, as it travels.
    pub(crate) fn read(&self, address: Address) -> Option<Vec<u8>> {
        let place = self.tables.dictionary.find(address).ok()?.place()?;
        match self.kept.get(usize::from(place.field))?.get(usize::from(place.item))? {
            Kept::Bytes(bytes) => Some(bytes.clone()),
            Kept::Bool(value) => Some(vec![u8::from(*value)]),
            Kept::Text(_) => None,
        }
    }

    /// Writes an entry that is kept, as far as its length goes.
    pub(crate) fn write(&mut self, address: Address, data: &[u8]) {
        let place = self.tables.dictionary.find(address).ok().and_then(|found| found.place());
        match place.and_then(|place| self.at(place)) {
            Some(Kept::Bytes(bytes)) => bytes.iter_mut().zip(data).for_each(|(to, from)| *to = *from),
            Some(Kept::Bool(value)) => *value = data.first().is_some_and(|byte| *byte != 0),
            Some(Kept::Text(_)) | None => {}
        }
    }

    /// Brings back what an entry has after start-up.
    pub(crate) fn reset(&mut self, address: Address) {
        let place = self.tables.dictionary.find(address).ok().and_then(|found| found.place());
        let Some(place) = place else { return };
        let defaults = self.tables.defaults.get(usize::from(place.field));
        let default = defaults.and_then(|defaults| defaults.get(usize::from(place.item)));
        if let (Some(value), Some(default)) = (self.at(place), default) {
            *value = default.clone();
        }
    }

    fn at(&mut self, place: Place) -> Option<&mut Kept> {
        self.kept.get_mut(usize::from(place.field))?.get_mut(usize::from(place.item))
    }
}

impl sdo::Values for Values {
    fn table(&self) -> &'static Dictionary {
        &self.tables.dictionary
    }

    fn ranges(&self) -> &'static [Range] {
        self.tables.ranges
    }

    fn has_complete_access(&self) -> bool {
        self.tables.has_complete_access
    }

    fn process_data(&self) -> Option<&'static PdoRules> {
        self.tables.rules.as_ref()
    }

    fn slot(&mut self, place: Place) -> Option<Slot<'_>> {
        Some(match self.at(place)? {
            Kept::Bool(value) => Slot::Bool(value),
            Kept::Bytes(bytes) => Slot::Bytes(bytes),
            Kept::Text(text) => Slot::Text(text),
        })
    }
}
