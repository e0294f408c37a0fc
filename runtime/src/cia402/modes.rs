//! The modes that a device has and how it goes from one to another.

use super::{Refusal, State, StateSet};

/// The modes of operation of a device, by their numbers (CiA 402, modes of operation 0x6060).
///
/// ```
/// use devc_runtime::cia402::{ModeChange, Modes, Refusal, State, StateSet};
///
/// // C887T0011, p. 11
/// const MODES: Modes = Modes {
///     supported: &[0, 6, 8],
///     changes: &[
///         ModeChange { from: &[0], to: &[6, 8] },
///         ModeChange { from: &[6], to: &[] },
///         ModeChange { from: &[8], to: &[] },
///     ],
///     selectable_in: StateSet::of(&[State::OperationEnabled]),
///     refusal: Refusal::Fault,
/// };
/// assert!(MODES.allows(6, 8));
/// assert!(!MODES.allows(0, 9));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Modes {
    /// The numbers of the modes; 0 among them if no mode can be chosen.
    pub supported: &'static [i8],
    /// The changes that the device makes; none if it makes all.
    pub changes: &'static [ModeChange],
    /// The states in which a change is taken.
    pub selectable_in: StateSet,
    /// What happens to a change that is not allowed.
    pub refusal: Refusal,
}

/// A change of mode that a device makes (C887T0011, p. 11).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModeChange {
    /// The modes before; any if there is none.
    pub from: &'static [i8],
    /// The modes after; any if there is none.
    pub to: &'static [i8],
}

impl Modes {
    /// Whether the device has the mode.
    pub fn has(&self, mode: i8) -> bool {
        self.supported.contains(&mode)
    }

    /// Whether the device goes from the one mode to the other, which it has.
    pub fn allows(&self, from: i8, to: i8) -> bool {
        let fits = |modes: &[i8], mode: i8| modes.is_empty() || modes.contains(&mode);
        let listed = || self.changes.iter().any(|change| fits(change.from, from) && fits(change.to, to));
        from == to || self.has(to) && (self.changes.is_empty() || listed())
    }

    /// Whether a change is taken in a state.
    pub fn are_selectable_in(&self, state: State) -> bool {
        self.selectable_in.contains(state)
    }
}
