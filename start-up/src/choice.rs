//! What a master chooses, and the list that follows from it.

use crate::list::List;
use crate::{MappedPdo, Period, Step};

/// What a master chooses before it goes to Safe-Operational.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice<'a> {
    /// What it sends.
    pub outputs: Way<'a>,
    /// What the device sends.
    pub inputs: Way<'a>,
    /// The objects of each axis that it writes.
    pub axes: &'a [AxisObjects],
    /// The mode of operation of each axis that has one.
    pub mode: Option<i8>,
    /// The cycle time of each axis that has 0x60C2.
    pub cycle: Option<Period>,
}

/// The process data of a direction, as a master chooses it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Way<'a> {
    /// The sync managers that PDOs are assigned to.
    pub carriers: &'a [Carrier<'a>],
    /// The PDOs that are mapped, as far as they are a master's own.
    pub mapped: &'a [MappedPdo<'a>],
    /// The PDOs that are assigned; the assignment is left as it is if none.
    pub assigned: Option<&'a [MappedPdo<'a>]>,
}

/// A sync manager that carries PDOs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Carrier<'a> {
    /// The object whose subindices name the PDOs: 0x1C10 and the number of the sync manager (ETG.1000.6).
    pub assignment: u16,
    /// The PDOs that are assigned if nobody changes it, by index.
    pub pdos: &'a [u16],
}

/// The objects of an axis that are written once, before it is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AxisObjects {
    /// Modes of operation, 0x6060 on the first axis.
    pub mode: Option<u16>,
    /// Interpolation time period, 0x60C2 on the first axis.
    pub cycle: Option<u16>,
}

impl Way<'_> {
    /// What the device has by default.
    pub const NONE: Self = Self { carriers: &[], mapped: &[], assigned: None };
}

impl<'a> Choice<'a> {
    /// What the device has by default.
    pub const NONE: Self = Self { outputs: Way::NONE, inputs: Way::NONE, axes: &[], mode: None, cycle: None };

    /// The writes that bring it about, in order, as far as there is room for them; and how many there are.
    ///
    /// The order is that of ETG.1020: assignments are cleared before mappings change, and a count is written after what it
    /// counts. What the device sends is mapped before what it receives.
    pub const fn steps(&self, into: &mut [Step]) -> usize {
        self.list(into, true)
    }

    /// What is there once all is written: the writes without those that later ones supersede.
    pub const fn lasting(&self, into: &mut [Step]) -> usize {
        self.list(into, false)
    }

    const fn list(&self, into: &mut [Step], clears: bool) -> usize {
        let Self { outputs, inputs, mut axes, .. } = *self;
        let mut list = List::new(into, clears);
        list.clear_assignments(&outputs);
        list.clear_assignments(&inputs);
        list.mappings(&inputs);
        list.mappings(&outputs);
        list.assignments(&outputs);
        list.assignments(&inputs);
        while let Some((axis, rest)) = axes.split_first() {
            list.axis(axis, self.mode, self.cycle);
            axes = rest;
        }
        list.length
    }
}
