//! The start-up list while it is being made.

use super::{AxisObjects, Write};
use crate::object::Address;
use crate::pdo::MappedPdo;

/// A list that is being made: those that do not fit are only counted.
pub(super) struct List<const N: usize> {
    pub(super) writes: [Write; N],
    pub(super) length: usize,
    /// Whether what is written only to be written again belongs to it.
    clears: bool,
}

impl<const N: usize> List<N> {
    pub(super) const fn new(clears: bool) -> Self {
        Self { writes: [Write::new(Address::new(0, 0), &[], ""); N], length: 0, clears }
    }

    pub(super) const fn write(mut self, index: u16, subindex: u8, data: &[u8], what: &'static str) -> Self {
        if let Some((_, rest)) = self.writes.split_at_mut_checked(self.length)
            && let Some(place) = rest.first_mut()
        {
            *place = Write::new(Address::new(index, subindex), data, what);
        }
        self.length += 1;
        self
    }

    pub(super) const fn clear(self, index: u16, what: &'static str) -> Self {
        if self.clears { self.write(index, 0, &[0], what) } else { self }
    }

    /// The mappings that are the user's own.
    pub(super) const fn mappings(mut self, pdos: Option<&'static [MappedPdo]>) -> Self {
        let mut pdos = match pdos {
            Some(pdos) => pdos,
            None => &[],
        };
        while let Some((pdo, rest)) = pdos.split_first() {
            if pdo.is_own {
                self = self.mapping(pdo);
            }
            pdos = rest;
        }
        self
    }

    const fn mapping(self, pdo: &MappedPdo) -> Self {
        let mut list = self.clear(pdo.index, "clear the mapping");
        let (mut entries, mut subindex) = (pdo.mapping, 0);
        while let Some((entry, rest)) = entries.split_first() {
            subindex += 1;
            list = list.write(pdo.index, subindex, &entry.word().to_le_bytes(), "map an entry");
            entries = rest;
        }
        list.write(pdo.index, 0, &[subindex], "number of entries")
    }

    pub(super) const fn assignment(mut self, index: u16, pdos: Option<&'static [MappedPdo]>) -> Self {
        let Some(mut pdos) = pdos else { return self };
        let mut subindex = 0;
        while let Some((pdo, rest)) = pdos.split_first() {
            subindex += 1;
            self = self.write(index, subindex, &pdo.index.to_le_bytes(), "assign a PDO");
            pdos = rest;
        }
        self.write(index, 0, &[subindex], "number of PDOs")
    }

    pub(super) const fn axis(
        mut self,
        axis: &AxisObjects,
        mode: Option<i8>,
        cycle: Option<(u8, i8)>,
    ) -> Self {
        if let (Some(index), Some(mode)) = (axis.mode, mode) {
            self = self.write(index, 0, &mode.to_le_bytes(), "mode of operation");
        }
        if let (Some(index), Some((count, exponent))) = (axis.cycle, cycle) {
            self = self.write(index, 1, &[count], "interpolation time period");
            self = self.write(index, 2, &exponent.to_le_bytes(), "its power of ten in seconds");
        }
        self
    }
}
