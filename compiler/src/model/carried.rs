//! What the sync managers of a direction carry together.

use std::collections::BTreeSet;

use super::{Device, Direction, Index, Role};

/// What a device lets a master assign to a direction of its process data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Carried {
    /// The assignment object of each sync manager, with the PDOs that are assigned to it if nobody changes it.
    pub carriers: Vec<(Index, Vec<Index>)>,
    /// Whether a master may write the assignment object.
    pub assignable: bool,
    /// The largest number of PDOs at once.
    pub slots: u8,
    /// The longest image in bytes, if the description says.
    pub max_size: Option<u16>,
    /// PDOs that have to be there.
    pub mandatory: Vec<Index>,
    /// Pairs of PDOs of which one has to be left out.
    pub exclusive: Vec<[Index; 2]>,
}

impl Device {
    /// What it lets a master assign to a direction; none if it has no sync manager for that.
    pub fn carried(&self, way: Direction) -> Option<Carried> {
        let managers = || self.sync_managers_of(Role::of(way));
        managers().next()?;
        let pairs: BTreeSet<[Index; 2]> = self
            .pdos_of(way)
            .flat_map(|pdo| pdo.excludes.iter().map(|other| [pdo.index.min(*other), pdo.index.max(*other)]))
            .collect();
        Some(Carried {
            carriers: managers().map(|manager| (manager.assignment(), manager.pdos.clone())).collect(),
            assignable: self.mailbox.as_ref().is_none_or(|mailbox| mailbox.pdo_assign),
            slots: managers().fold(0, |sum, manager| sum.saturating_add(manager.slots)),
            max_size: managers().try_fold(0_u16, |sum, manager| Some(sum.saturating_add(manager.max_size?))),
            mandatory: self.pdos_of(way).filter(|pdo| pdo.mandatory).map(|pdo| pdo.index).collect(),
            exclusive: pairs.into_iter().collect(),
        })
    }
}
