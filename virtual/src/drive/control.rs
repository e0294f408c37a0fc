//! The state machines of the axes: one each, or one for all.

use devc_runtime::cia402::{Coupled, Drive, Events, Machine, State, Step};

/// As many axes as can share a state: those that CiA 402 has room for, 0x800 indices each from 0x6000 on. The runtime counts
/// axes when it is compiled; places that no axis has do what the first does, so that they neither hinder the others nor act
/// for them.
const MOST: usize = 8;

/// The machines.
#[derive(Debug, Clone)]
pub(super) enum Control {
    /// Each axis has a state of its own.
    Each(Vec<Drive>),
    /// All have the same, and follow the controlword of the first.
    Together(Box<Coupled<MOST>>),
}

impl Control {
    /// Just switched on.
    pub(super) fn new(machine: &'static Machine, axes: usize, is_coupled: bool) -> Self {
        match is_coupled {
            true => Self::Together(Box::new(Coupled::new(machine))),
            false => Self::Each(vec![Drive::new(machine); axes]),
        }
    }

    /// The state that an axis shows.
    pub(super) fn state(&self, axis: usize) -> State {
        match self {
            Self::Each(drives) => drives.get(axis).map_or(State::NotReadyToSwitchOn, Drive::state),
            Self::Together(coupled) => coupled.state(),
        }
    }

    /// The statusword of an axis, with the bits that are none of the state as given.
    pub(super) fn statusword(&self, axis: usize, others: u16) -> u16 {
        match self {
            Self::Each(drives) => drives.get(axis).map_or(others, |drive| drive.statusword(others)),
            Self::Together(coupled) => coupled.statusword(others),
        }
    }

    /// One cycle: the controlword of each axis, and what holds on it. The transitions, each with the axes that made it.
    pub(super) fn cycle(&mut self, axes: &[(u16, Events)]) -> Vec<(usize, Step)> {
        match self {
            Self::Each(drives) => {
                let axes = drives.iter_mut().zip(axes).enumerate();
                let steps = axes.map(|(axis, (drive, (word, events)))| (axis, drive.cycle(*word, *events)));
                steps.filter_map(|(axis, step)| Some((axis, step?))).collect()
            }
            Self::Together(coupled) => {
                let Some((word, first)) = axes.first() else { return Vec::new() };
                let mut events = [*first; MOST];
                for (place, (_, event)) in events.iter_mut().zip(axes) {
                    *place = *event;
                }
                let step = coupled.cycle(*word, events);
                step.into_iter().flat_map(|step| (0..axes.len()).map(move |axis| (axis, step))).collect()
            }
        }
    }
}
