//! From a statusword to a state.

use core::fmt;

use super::{Pattern, State, StateSet};

/// How a device shows its states in the statusword 0x6041 (CiA 402, statusword, state coding).
///
/// ```
/// use devc_runtime::cia402::{Pattern, State, StatePatterns};
///
/// // two states that this drive does not keep apart
/// const STATES: StatePatterns = StatePatterns(&[
///     (State::NotReadyToSwitchOn, Pattern { mask: 0x4F, value: 0x40 }),
///     (State::SwitchOnDisabled, Pattern { mask: 0x4F, value: 0x40 }),
///     (State::ReadyToSwitchOn, Pattern { mask: 0x4F, value: 0x01 }),
/// ]);
///
/// assert_eq!(STATES.decode(0x0231), Ok(State::ReadyToSwitchOn));
/// assert_eq!(
///     STATES.decode(0x0040).unwrap_err().to_string(),
///     "statusword 0x0040 fits several states: not ready to switch on, switch on disabled"
/// );
/// assert_eq!(STATES.decode(0x000F).unwrap_err().to_string(), "statusword 0x000F fits no state");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StatePatterns(
    /// The states that the device has, each with a pattern of it.
    pub &'static [(State, Pattern)],
);

impl StatePatterns {
    /// Every state that the word fits (S700, 3.4.3: two states have one pattern).
    #[inline]
    pub fn fitting(self, statusword: u16) -> StateSet {
        let fits = self.0.iter().filter(|(_, pattern)| pattern.matches(statusword));
        fits.fold(StateSet::NONE, |set, (state, _)| set.with(*state))
    }

    /// The state that the word shows (CiA 402, state coding), if it fits just one.
    #[inline]
    pub fn decode(self, statusword: u16) -> Result<State, UnknownState> {
        let candidates = self.fitting(statusword);
        candidates.single().ok_or(UnknownState { statusword, candidates })
    }

    /// A word that shows `state`, with every bit that does not count 0; `None` for a state that the device has not.
    pub fn encode(self, state: State) -> Option<u16> {
        self.0.iter().find(|(of, _)| *of == state).map(|(_, pattern)| pattern.value)
    }

    /// A statusword that shows `state`, with the bits that do not count as given; the bits alone for a state that the
    /// device has not.
    #[inline]
    pub fn show(self, state: State, other_bits: u16) -> u16 {
        let pattern = self.0.iter().find(|(of, _)| *of == state);
        pattern.map_or(other_bits, |(_, pattern)| pattern.apply(other_bits))
    }
}

/// A statusword that does not tell the state (CiA 402, state coding).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnknownState {
    /// The word as it came.
    pub statusword: u16,
    /// The states that it fits: none, or several that the device does not keep apart.
    pub candidates: StateSet,
}

impl fmt::Display for UnknownState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "statusword 0x{:04X} fits ", self.statusword)?;
        if self.candidates.is_empty() {
            f.write_str("no state")
        } else {
            write!(f, "several states: {}", self.candidates)
        }
    }
}

impl core::error::Error for UnknownState {}
