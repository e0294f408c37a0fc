//! A write of the list.

use crate::Address;

/// A write of the list: an SDO download on the way from Pre-Operational to Safe-Operational.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// Where to.
    pub address: Address,
    /// What for.
    pub task: Task,
    data: [u8; 4],
    length: usize,
}

impl Step {
    /// What a place of a list holds before it is made.
    pub const NONE: Self = Self::new(Address::new(0, 0), Task::CountPdos, &[]);

    /// A write of the first four bytes of the data, as they travel.
    pub(crate) const fn new(address: Address, task: Task, data: &[u8]) -> Self {
        let mut step = Self { address, task, data: [0; 4], length: 0 };
        let (mut places, mut bytes): (&mut [u8], _) = (&mut step.data, data);
        while let (Some((place, others)), Some((byte, rest))) =
            (places.split_first_mut(), bytes.split_first())
        {
            *place = *byte;
            step.length += 1;
            (places, bytes) = (others, rest);
        }
        step
    }

    /// The data, as it travels: little-endian.
    pub const fn data(&self) -> &[u8] {
        match self.data.split_at_checked(self.length) {
            Some((data, _)) => data,
            None => &[],
        }
    }
}

/// What a write of the list is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// Takes all PDOs out of an assignment object.
    ClearAssignment,
    /// Takes all entries out of a mapping object.
    ClearMapping,
    /// Puts an entry into a mapping object.
    Map,
    /// Says how many entries a mapping object has.
    CountEntries,
    /// Puts a PDO into an assignment object.
    Assign,
    /// Says how many PDOs an assignment object has.
    CountPdos,
    /// Chooses the mode of operation.
    Mode,
    /// Sets how many units of time a cycle has.
    Period,
    /// Sets the unit of time.
    Exponent,
}

impl Task {
    /// What it is for, in words.
    pub const fn text(self) -> &'static str {
        match self {
            Self::ClearAssignment => "clear the assignment",
            Self::ClearMapping => "clear the mapping",
            Self::Map => "map an entry",
            Self::CountEntries => "number of entries",
            Self::Assign => "assign a PDO",
            Self::CountPdos => "number of PDOs",
            Self::Mode => "mode of operation",
            Self::Period => "interpolation time period",
            Self::Exponent => "its power of ten in seconds",
        }
    }
}
