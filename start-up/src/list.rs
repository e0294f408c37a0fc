//! The list while it is being made.

use crate::mapping::has;
use crate::{Address, AxisObjects, Carrier, MappedPdo, Period, Step, Task, Way};

/// The last subindex of an object that lists something (ETG.1000.6).
const LAST: u8 = 254;

/// A list that is being made: writes that there is no room for are only counted.
pub(crate) struct List<'l> {
    places: &'l mut [Step],
    pub(crate) length: usize,
    /// Whether what is written only to be written again belongs to it.
    clears: bool,
}

impl<'l> List<'l> {
    pub(crate) const fn new(places: &'l mut [Step], clears: bool) -> Self {
        Self { places, length: 0, clears }
    }

    const fn write(&mut self, index: u16, subindex: u8, data: &[u8], task: Task) {
        if let Some((_, [place, ..])) = self.places.split_at_mut_checked(self.length) {
            *place = Step::new(Address::new(index, subindex), task, data);
        }
        self.length += 1;
    }

    const fn clear(&mut self, index: u16, task: Task) {
        if self.clears {
            self.write(index, 0, &[0], task);
        }
    }

    pub(crate) const fn clear_assignments(&mut self, way: &Way<'_>) {
        let mut carriers = if way.assigned.is_some() { way.carriers } else { &[] };
        while let Some((carrier, rest)) = carriers.split_first() {
            self.clear(carrier.assignment, Task::ClearAssignment);
            carriers = rest;
        }
    }

    /// The mappings that are a master's own.
    pub(crate) const fn mappings(&mut self, way: &Way<'_>) {
        let mut pdos = way.mapped;
        while let Some((pdo, rest)) = pdos.split_first() {
            if pdo.is_own {
                self.mapping(pdo);
            }
            pdos = rest;
        }
    }

    const fn mapping(&mut self, pdo: &MappedPdo<'_>) {
        self.clear(pdo.index, Task::ClearMapping);
        let (mut entries, mut count) = (pdo.mapping, 0);
        while let Some((entry, rest)) = entries.split_first()
            && count < LAST
        {
            count += 1;
            self.write(pdo.index, count, &entry.word().to_le_bytes(), Task::Map);
            entries = rest;
        }
        self.write(pdo.index, 0, &[count], Task::CountEntries);
    }

    /// Each PDO in the sync manager that carries it by default, or in the first.
    pub(crate) const fn assignments(&mut self, way: &Way<'_>) {
        let Some(pdos) = way.assigned else { return };
        let Some((first, others)) = way.carriers.split_first() else { return };
        self.assignment(first, pdos, Some(others));
        let mut carriers = others;
        while let Some((carrier, rest)) = carriers.split_first() {
            self.assignment(carrier, pdos, None);
            carriers = rest;
        }
    }

    /// What is assigned to a sync manager; to the first what none of the others carries, too.
    const fn assignment(
        &mut self,
        carrier: &Carrier<'_>,
        mut pdos: &[MappedPdo<'_>],
        others: Option<&[Carrier<'_>]>,
    ) {
        let mut count = 0;
        while let Some((pdo, rest)) = pdos.split_first()
            && count < LAST
        {
            let is_left = match others {
                Some(others) => !have(others, pdo.index),
                None => false,
            };
            if is_left || has(carrier.pdos, pdo.index) {
                count += 1;
                self.write(carrier.assignment, count, &pdo.index.to_le_bytes(), Task::Assign);
            }
            pdos = rest;
        }
        self.write(carrier.assignment, 0, &[count], Task::CountPdos);
    }

    pub(crate) const fn axis(&mut self, axis: &AxisObjects, mode: Option<i8>, cycle: Option<Period>) {
        if let (Some(index), Some(mode)) = (axis.mode, mode) {
            self.write(index, 0, &mode.to_le_bytes(), Task::Mode);
        }
        if let (Some(index), Some(Period { count, exponent })) = (axis.cycle, cycle) {
            self.write(index, 1, &[count], Task::Period);
            self.write(index, 2, &exponent.to_le_bytes(), Task::Exponent);
        }
    }
}

/// Whether one of the sync managers carries a PDO by default.
const fn have(mut carriers: &[Carrier<'_>], pdo: u16) -> bool {
    while let Some((carrier, rest)) = carriers.split_first() {
        if has(carrier.pdos, pdo) {
            return true;
        }
        carriers = rest;
    }
    false
}
