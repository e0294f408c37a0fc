//! The writes through the mailbox that bring a configuration about.
//!
//! Which they are, and in which order, says `devc-start-up`; what the mailbox does not let a master write is not in it. Other
//! values come in front if they are written on the way to Pre-Operational, else behind.

use std::collections::BTreeMap;

use devc_start_up::{AxisObjects, Carrier, Choice, MappedPdo, Mapping, Step, Task, Way};

use super::derived::Basis;
use crate::model::{
    Address, Axis, Configuration, Direction, Index, Mapped, Object, Role, SdoWrite, SyncManager,
};

/// What of a device bears on its start-up lists.
pub(super) struct StartUp<'a> {
    assigns: bool,
    maps: bool,
    managers: &'a [SyncManager],
    axes: Vec<AxisObjects>,
}

/// What is chosen of a direction.
struct Chosen<'a> {
    managers: Vec<(u16, Vec<u16>)>,
    mapped: Vec<(u16, Vec<Mapping>)>,
    assigned: Option<&'a [Index]>,
}

impl<'a> StartUp<'a> {
    pub(super) fn of(axes: &[Axis], objects: &[Object], basis: &Basis<'a>) -> Self {
        Self {
            assigns: basis.mailbox.is_none_or(|mailbox| mailbox.pdo_assign),
            maps: basis.mailbox.is_none_or(|mailbox| mailbox.pdo_config),
            managers: basis.sync_managers,
            axes: Axis::set_objects(axes, objects),
        }
    }

    /// The start-up list of a configuration, in order.
    pub(super) fn list(&self, configuration: &Configuration) -> Vec<SdoWrite> {
        let [outputs, inputs] = [Direction::Rx, Direction::Tx].map(|way| self.chosen(configuration, way));
        let steps = outputs.way(|outputs| inputs.way(|inputs| self.steps(configuration, outputs, inputs)));
        let names = Names::of(configuration);
        let steps = steps.iter().map(|step| names.write(step));
        let others = |is_first: bool| {
            let others = configuration.writes.iter().map(|chosen| chosen.write.clone());
            others.filter(move |write| (write.transition == "IP") == is_first)
        };
        others(true).chain(steps).chain(others(false)).collect()
    }

    fn steps(&self, configuration: &Configuration, outputs: Way<'_>, inputs: Way<'_>) -> Vec<Step> {
        let mode = configuration.mode.and_then(|mode| i8::try_from(mode).ok());
        let cycle = configuration.cycle_time.and_then(|time| time.interpolation());
        let choice = Choice { outputs, inputs, axes: &self.axes, mode, cycle };
        let mut steps = vec![Step::NONE; choice.steps(&mut [])];
        choice.steps(&mut steps);
        steps
    }

    fn chosen<'c>(&self, configuration: &'c Configuration, way: Direction) -> Chosen<'c> {
        let managers = self.managers.iter().filter(|manager| manager.role == Role::of(way));
        let pdos = |manager: &SyncManager| manager.pdos.iter().map(|pdo| pdo.0).collect();
        let mut managers: Vec<_> = managers.map(|manager| (manager.assignment().0, pdos(manager))).collect();
        if managers.is_empty() {
            managers.push((usual(way), Vec::new()));
        }
        let mapped = configuration.mapping.iter().filter(|pdo| self.maps && pdo.direction == way);
        let mapped = mapped.map(|pdo| (pdo.index.0, pdo.entries.iter().map(Mapped::mapping).collect()));
        let assigned = configuration.assigned(way).filter(|_| self.assigns);
        Chosen { managers, mapped: mapped.collect(), assigned }
    }
}

/// The assignment object of a direction in a device that tells of no sync manager.
fn usual(way: Direction) -> u16 {
    match way {
        Direction::Rx => 0x1C12,
        Direction::Tx => 0x1C13,
    }
}

impl Chosen<'_> {
    fn way<T>(&self, then: impl FnOnce(Way<'_>) -> T) -> T {
        let carriers = self.managers.iter();
        let carriers: Vec<_> =
            carriers.map(|(assignment, pdos)| Carrier { assignment: *assignment, pdos }).collect();
        let mapped: Vec<_> = self.mapped.iter().map(|(index, it)| MappedPdo::own(*index, it)).collect();
        let assigned: Option<Vec<_>> =
            self.assigned.map(|pdos| pdos.iter().map(|pdo| MappedPdo::new(pdo.0, &[])).collect());
        then(Way { carriers: &carriers, mapped: &mapped, assigned: assigned.as_deref() })
    }
}

/// The names of what is mapped, by the mapping object and its subindex.
struct Names<'a>(BTreeMap<(u16, u8), &'a str>);

impl<'a> Names<'a> {
    fn of(configuration: &'a Configuration) -> Self {
        let entries = configuration.mapping.iter().flat_map(|pdo| {
            let numbered = (1..=u8::MAX).zip(&pdo.entries);
            numbered.map(move |(subindex, entry)| ((pdo.index.0, subindex), entry.name.as_str()))
        });
        Self(entries.collect())
    }

    fn write(&self, step: &Step) -> SdoWrite {
        let devc_start_up::Address { index, subindex } = step.address;
        let comment = match (step.task, step.data()) {
            (Task::ClearAssignment, _) => format!("clear the assignment {}", Index(index)),
            (Task::ClearMapping, _) => format!("clear the mapping of {}", Index(index)),
            (Task::Map, _) => format!("map {}", self.0.get(&(index, subindex)).unwrap_or(&"an entry")),
            (Task::CountEntries, _) => format!("number of entries of {}", Index(index)),
            (Task::Assign, [low, high]) => format!("assign {}", Index(u16::from_le_bytes([*low, *high]))),
            (Task::CountPdos, _) => format!("number of PDOs in {}", Index(index)),
            (task, _) => task.text().to_owned(),
        };
        let address = Address { index: Index(index), subindex };
        SdoWrite { transition: "PS".to_owned(), address, data: step.data().to_vec(), comment }
    }
}
