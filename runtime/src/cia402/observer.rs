//! From statuswords to a state, with what went before.

use super::{Machine, State, StateSet, UnknownState};

/// Follows the states of a drive through its statuswords, so that states which share a pattern can be told apart by
/// the one before (S700, 3.4.3: not ready to switch on and switch on disabled).
///
/// Where that does not tell either, the later state in the order of the profile is taken: what the master sends in it
/// does nothing in the earlier one.
///
/// ```
/// use devc_runtime::cia402::{Machine, Observer, Pattern, State, StatePatterns, generic};
///
/// const MACHINE: Machine = Machine {
///     states: StatePatterns(&[
///         (State::NotReadyToSwitchOn, Pattern { mask: 0x4F, value: 0x40 }),
///         (State::SwitchOnDisabled, Pattern { mask: 0x4F, value: 0x40 }),
///         (State::ReadyToSwitchOn, Pattern { mask: 0x4F, value: 0x01 }),
///     ]),
///     ..generic::MACHINE
/// };
///
/// let mut observer = Observer::new(&MACHINE);
/// assert_eq!(observer.observe(0x0040), Ok(State::SwitchOnDisabled));
/// assert_eq!(observer.possible().to_string(), "not ready to switch on, switch on disabled");
/// observer.observe(0x0001).unwrap();
/// observer.observe(0x0040).unwrap();
/// assert_eq!(observer.possible().to_string(), "switch on disabled");
/// assert!(observer.observe(0x000F).is_err());
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Observer {
    machine: &'static Machine,
    possible: StateSet,
}

impl Observer {
    /// Nothing seen yet.
    pub const fn new(machine: &'static Machine) -> Self {
        Self { machine, possible: StateSet::ALL }
    }

    /// The states that the drive may be in after the last statusword.
    pub const fn possible(&self) -> StateSet {
        self.possible
    }

    /// The state that the next statusword shows (CiA 402, state coding). A word that fits no state changes nothing.
    pub fn observe(&mut self, statusword: u16) -> Result<State, UnknownState> {
        let fitting = self.machine.states.fitting(statusword);
        let following = fitting.common(self.reachable());
        // a drive that was switched off and on comes from anywhere
        let candidates = if following.is_empty() { fitting } else { following };
        let state = candidates.iter().last().ok_or(UnknownState { statusword, candidates })?;
        self.possible = candidates;
        Ok(state)
    }

    /// Where transitions lead from what was possible; several, for statuswords get lost.
    fn reachable(&self) -> StateSet {
        let follow = |set: StateSet| {
            let leaving = self.machine.transitions.iter().filter(|one| !one.from.common(set).is_empty());
            leaving.fold(set, |set, transition| set.with(transition.to))
        };
        State::ALL.iter().fold(self.possible, |set, _| follow(set))
    }
}
