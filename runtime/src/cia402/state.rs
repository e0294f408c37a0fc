//! The states of a drive.

use core::fmt;

/// A state of the power drive system's finite state automaton (CiA 402; IEC 61800-7-201, PDS FSA).
///
/// The number of a state is its bit in a [`StateSet`]; it means nothing on the wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum State {
    /// The drive starts up or tests itself.
    NotReadyToSwitchOn = 0x01,
    /// Started; power must not be switched on yet. Parameters may be changed.
    SwitchOnDisabled = 0x02,
    /// Power may be switched on.
    ReadyToSwitchOn = 0x04,
    /// Power is on, the drive does not act on it.
    SwitchedOn = 0x08,
    /// The drive follows its mode of operation.
    OperationEnabled = 0x10,
    /// The drive stops, or stands after a quick stop with its function still enabled.
    QuickStopActive = 0x20,
    /// A fault was found and the drive reacts to it.
    FaultReactionActive = 0x40,
    /// The reaction is over, the drive is off until the fault is reset.
    Fault = 0x80,
}

impl State {
    /// All eight, in the order of the profile.
    pub const ALL: [Self; 8] = [
        Self::NotReadyToSwitchOn,
        Self::SwitchOnDisabled,
        Self::ReadyToSwitchOn,
        Self::SwitchedOn,
        Self::OperationEnabled,
        Self::QuickStopActive,
        Self::FaultReactionActive,
        Self::Fault,
    ];

    /// The profile's name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NotReadyToSwitchOn => "not ready to switch on",
            Self::SwitchOnDisabled => "switch on disabled",
            Self::ReadyToSwitchOn => "ready to switch on",
            Self::SwitchedOn => "switched on",
            Self::OperationEnabled => "operation enabled",
            Self::QuickStopActive => "quick stop active",
            Self::FaultReactionActive => "fault reaction active",
            Self::Fault => "fault",
        }
    }
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Some of the states (CiA 402, PDS FSA).
///
/// ```
/// use devc_runtime::cia402::{State, StateSet};
///
/// let powered = StateSet::of(&[State::SwitchedOn, State::OperationEnabled]);
/// assert!(powered.contains(State::SwitchedOn));
/// assert_eq!(powered.to_string(), "switched on, operation enabled");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct StateSet(u8);

impl StateSet {
    /// No state.
    pub const NONE: Self = Self(0);
    /// Every state.
    pub const ALL: Self = Self(u8::MAX);

    /// These states.
    pub const fn of(mut states: &[State]) -> Self {
        let mut set = Self::NONE;
        while let [state, rest @ ..] = states {
            set = set.with(*state);
            states = rest;
        }
        set
    }

    /// These and `state`.
    #[must_use]
    pub const fn with(self, state: State) -> Self {
        Self(self.0 | state as u8)
    }

    /// These without `state`.
    #[must_use]
    pub const fn without(self, state: State) -> Self {
        Self(self.0 & !(state as u8))
    }

    /// These and `others`.
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Those that are in both.
    #[must_use]
    pub const fn common(self, others: Self) -> Self {
        Self(self.0 & others.0)
    }

    /// Whether `state` is one of them.
    pub const fn contains(self, state: State) -> bool {
        self.0 & state as u8 != 0
    }

    /// Whether there is none.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The state, if it is just one.
    pub fn single(self) -> Option<State> {
        State::ALL.into_iter().find(|state| *state as u8 == self.0)
    }

    /// Each of them, in the order of the profile.
    pub fn iter(self) -> impl Iterator<Item = State> {
        State::ALL.into_iter().filter(move |state| self.contains(*state))
    }
}

impl fmt::Display for StateSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return f.write_str("none");
        }
        for (position, state) in self.iter().enumerate() {
            f.write_str(if position == 0 { "" } else { ", " })?;
            f.write_str(state.name())?;
        }
        Ok(())
    }
}

impl fmt::Debug for StateSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}
