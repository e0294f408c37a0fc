//! Which objects process data is made by, and what a device lets a master write to them.

use crate::pdo::{Direction, Rx, SyncManager};
use crate::sdo::Access;

/// What a device lets a master make its process data of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PdoRules {
    /// What may be assigned to the outputs, if it has any.
    pub outputs: Option<SyncManager>,
    /// What may be assigned to the inputs, if it has any.
    pub inputs: Option<SyncManager>,
    /// PDOs that take no more than a number of bytes, with that.
    pub max_bytes: &'static [(u16, u16)],
}

/// Which way process data goes, where it is not known before the program runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Rx,
    Tx,
}

/// What an object says of process data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// What is mapped to a PDO.
    Mapping(Way),
    /// Which PDOs are assigned.
    Assignment(Way),
}

impl Way {
    /// That of a direction.
    pub(super) const fn of<D: Direction>() -> Self {
        if D::ASSIGNMENT == Rx::ASSIGNMENT { Self::Rx } else { Self::Tx }
    }

    /// That of a PDO, by its mapping object (ETG.1000.6, object dictionary areas); none if it is not one.
    pub(super) const fn of_pdo(index: u16) -> Option<Self> {
        match index {
            0x1600..=0x17FF => Some(Self::Rx),
            0x1A00..=0x1BFF => Some(Self::Tx),
            _ => None,
        }
    }

    /// The right that an entry needs to be mapped.
    pub(super) const fn right(self) -> Access {
        match self {
            Self::Rx => Access::RX_PDO,
            Self::Tx => Access::TX_PDO,
        }
    }
}

impl PdoRules {
    /// The role of an object; none if it has nothing to do with process data.
    pub(super) fn role(&self, index: u16) -> Option<Role> {
        let assigns = |way: &Way| self.assignments(*way).any(|assignment| assignment == index);
        match Way::of_pdo(index) {
            Some(way) => Some(Role::Mapping(way)),
            None => [Way::Rx, Way::Tx].into_iter().find(assigns).map(Role::Assignment),
        }
    }

    /// The objects that name the PDOs of a direction, one for each sync manager of it.
    pub(super) fn assignments(&self, way: Way) -> impl Iterator<Item = u16> {
        self.manager(way).into_iter().flat_map(|manager| manager.carriers).map(|carrier| carrier.assignment)
    }

    /// What may be assigned.
    pub(super) const fn manager(&self, way: Way) -> Option<&SyncManager> {
        match way {
            Way::Rx => self.outputs.as_ref(),
            Way::Tx => self.inputs.as_ref(),
        }
    }

    /// The most bits that a PDO takes, by itself and as its sync manager carries them.
    pub(super) fn most_bits(&self, pdo: u16, way: Way) -> Option<usize> {
        let own = self.max_bytes.iter().find(|(index, _)| *index == pdo).map(|(_, bytes)| *bytes);
        let carried = self.manager(way).and_then(|manager| manager.max_size);
        own.into_iter().chain(carried).min().map(bits)
    }
}

/// The bits of so many bytes.
pub(super) const fn bits(bytes: u16) -> usize {
    (bytes as usize).saturating_mul(8)
}
