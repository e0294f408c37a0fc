//! What a master works for.

use crate::cia402::State;

/// A state that can be asked for (CiA 402, PDS FSA).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Goal {
    /// Without power.
    SwitchOnDisabled,
    /// Without power, that may be switched on.
    ReadyToSwitchOn,
    /// With power, not acting on it.
    SwitchedOn,
    /// Following the targets.
    OperationEnabled,
}

impl Goal {
    /// All of them, in the order in which a drive comes through them (CiA 402, PDS FSA).
    pub const ALL: [Self; 4] =
        [Self::SwitchOnDisabled, Self::ReadyToSwitchOn, Self::SwitchedOn, Self::OperationEnabled];

    /// The state.
    pub const fn state(self) -> State {
        match self {
            Self::SwitchOnDisabled => State::SwitchOnDisabled,
            Self::ReadyToSwitchOn => State::ReadyToSwitchOn,
            Self::SwitchedOn => State::SwitchedOn,
            Self::OperationEnabled => State::OperationEnabled,
        }
    }
}

/// What the requests come to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Aim {
    /// Out of operation, and no further.
    Rest,
    /// Out of operation by a quick stop.
    QuickStop,
    /// Out of a fault.
    FaultReset,
    /// To a state.
    Goal(Goal),
}

impl Aim {
    pub(super) const fn goal(self) -> Option<Goal> {
        match self {
            Self::Goal(goal) => Some(goal),
            Self::Rest | Self::QuickStop | Self::FaultReset => None,
        }
    }

    /// The state where it is reached.
    pub(super) const fn target(self) -> Option<State> {
        match self {
            Self::Goal(goal) => Some(goal.state()),
            Self::FaultReset => Some(State::SwitchOnDisabled),
            Self::Rest | Self::QuickStop => None,
        }
    }

    pub(super) const fn is_operation(self) -> bool {
        matches!(self, Self::Goal(Goal::OperationEnabled))
    }
}
