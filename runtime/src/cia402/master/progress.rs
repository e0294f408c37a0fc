//! How far the master has come, and what keeps it.

use core::fmt;

use super::Goal;
use crate::cia402::State;

/// How far a [`Master`](super::Master) has come.
///
/// ```
/// use devc_runtime::cia402::{Awaited, Progress, State, Waiting};
///
/// let progress = Progress::Overdue(Waiting {
///     state: Some(State::SwitchOnDisabled),
///     awaits: Awaited::Transition { number: 2, command: "shutdown" },
/// });
/// assert_eq!(
///     progress.to_string(),
///     "gave up: in switch on disabled, transition 2 by shutdown did not come"
/// );
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// Nothing was requested yet.
    Idle,
    /// What was requested holds.
    Reached,
    /// The next thing has not come yet.
    Waiting(Waiting),
    /// It did not come in time. The request is gone.
    Overdue(Waiting),
    /// The drive went another way. The request is gone.
    Withdrawn(Withdrawal),
}

/// What a master waits for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Waiting {
    /// The state that the drive is in; none if it has not shown one yet.
    pub state: Option<State>,
    /// What has to come.
    pub awaits: Awaited,
}

/// What has to come (CiA 402, PDS FSA, and modes of operation display 0x6061).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Awaited {
    /// The drive has to make a transition that is commanded.
    Transition {
        /// Its number.
        number: u8,
        /// The command's name.
        command: &'static str,
    },
    /// The drive has to make a transition by itself.
    Automatic {
        /// Its number.
        number: u8,
    },
    /// The caller has to set targets to actual values, and say so.
    Seed,
    /// The drive has to display the mode.
    Mode {
        /// What 0x6060 asks for.
        asked: i8,
        /// What 0x6061 displays.
        displayed: i8,
    },
    /// The statusword has to show a state that the device's description knows.
    State {
        /// The word as it came.
        statusword: u16,
    },
}

/// Why a request is gone: the drive left the way to it (CiA 402, transitions 12 to 14 and those back to switch on
/// disabled).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Withdrawal {
    /// What was requested; none if it was a fault reset.
    pub goal: Option<Goal>,
    /// The state before.
    pub from: State,
    /// The state after; the same if there was no way from the start.
    pub to: State,
}

impl Waiting {
    /// Whether it is the same wait; numbers that come from the drive may differ.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let is_kind = core::mem::discriminant(&self.awaits) == core::mem::discriminant(&other.awaits);
        is_kind && self.state == other.state
    }
}

impl fmt::Display for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Idle => f.write_str("idle"),
            Self::Reached => f.write_str("reached"),
            Self::Waiting(waiting) => write!(f, "waiting: {waiting} has not come yet"),
            Self::Overdue(waiting) => write!(f, "gave up: {waiting} did not come"),
            Self::Withdrawn(withdrawal) => withdrawal.fmt(f),
        }
    }
}

impl fmt::Display for Waiting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "in {}, {}", self.state.map_or("no known state", State::name), self.awaits)
    }
}

impl fmt::Display for Awaited {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Transition { number, command } => write!(f, "transition {number} by {command}"),
            Self::Automatic { number } => write!(f, "transition {number}, which the drive makes by itself,"),
            Self::Seed => f.write_str("the word that targets are set to actual values"),
            Self::Mode { asked, displayed } => write!(f, "mode {asked} instead of {displayed}"),
            Self::State { statusword } => write!(f, "a state instead of statusword 0x{statusword:04X}"),
        }
    }
}

impl fmt::Display for Withdrawal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let goal = self.goal.map_or("fault reset", |goal| goal.state().name());
        if self.from == self.to {
            write!(f, "{goal} withdrawn: no way from {}", self.to)
        } else {
            write!(f, "{goal} withdrawn: the drive went from {} to {}", self.from, self.to)
        }
    }
}
