//! From a state to a state.

use super::{State, StateSet};

/// A transition of the state machine (CiA 402, PDS FSA transitions).
///
/// ```
/// use devc_runtime::cia402::{Coupling, State, StateSet, Transition};
///
/// let enable =
///     Transition { number: 4, from: StateSet::of(&[State::SwitchedOn]), to: State::OperationEnabled, coupling: Coupling::All };
/// assert!(enable.leads(State::SwitchedOn, State::OperationEnabled));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Transition {
    /// The number in the profile, 0 to 16.
    pub number: u8,
    /// Where it starts; none for the one that the device makes when it is switched on.
    pub from: StateSet,
    /// Where it ends.
    pub to: State,
    /// What it takes that the device as a whole makes it.
    pub coupling: Coupling,
}

impl Transition {
    /// Whether it leads from the one state to the other (CiA 402, PDS FSA transitions).
    pub fn leads(&self, from: State, to: State) -> bool {
        self.from.contains(from) && self.to == to
    }
}

/// Which axes have to make a transition before the device does (C887T0011, p. 10 and 12).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Coupling {
    /// Axes are independent, each has its own state.
    Independent,
    /// All axes have to make it.
    All,
    /// It is enough that one axis makes it.
    Any,
}
