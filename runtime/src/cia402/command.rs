//! From a command to controlwords.

use super::{Pattern, StateSet};

/// A change of one bit from a cycle to the next (CiA 402, fault reset; S700, 3.4.2, for most commands).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Edge {
    /// The bit of this mask goes from 0 to 1.
    Rising(u16),
    /// The bit of this mask goes from 1 to 0.
    Falling(u16),
}

impl Edge {
    /// Whether the change happened between two words (S700, 3.4.2: P and N).
    #[inline]
    pub const fn happened(self, previous: u16, current: u16) -> bool {
        match self {
            Self::Rising(mask) => !previous & current & mask != 0,
            Self::Falling(mask) => previous & !current & mask != 0,
        }
    }

    /// The word with the bit as it is before the change.
    #[inline]
    #[must_use]
    pub const fn before(self, word: u16) -> u16 {
        match self {
            Self::Rising(mask) => word & !mask,
            Self::Falling(mask) => word | mask,
        }
    }

    /// The word with the bit as it is after the change.
    #[inline]
    #[must_use]
    pub const fn after(self, word: u16) -> u16 {
        match self {
            Self::Rising(mask) => word | mask,
            Self::Falling(mask) => word & !mask,
        }
    }
}

/// A command to the state machine, given with the controlword 0x6040 (CiA 402, controlword, command coding).
///
/// Commands may share a pattern, as "switch on" and "disable operation" do: the state decides which one it is.
///
/// A command with an edge takes two words, so that a held bit is never a second command:
///
/// ```
/// use devc_runtime::cia402::{Command, Edge, Pattern, StateSet};
///
/// const FAULT_RESET: Command = Command {
///     name: "fault reset",
///     pattern: Pattern { mask: 0x0080, value: 0x0080 },
///     edge: Some(Edge::Rising(0x0080)),
///     transitions: &[15],
///     ignored_in: StateSet::NONE,
/// };
///
/// let (first, second) = (FAULT_RESET.prepare(0x0086), FAULT_RESET.apply(0x0086));
/// assert_eq!((first, second), (0x0006, 0x0086));
/// assert!(FAULT_RESET.is_given(first, second));
/// assert!(!FAULT_RESET.is_given(second, second));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Command {
    /// The name that the manual uses.
    pub name: &'static str,
    /// The controlword while the command is given.
    pub pattern: Pattern,
    /// The change that gives it, if the pattern alone does not.
    pub edge: Option<Edge>,
    /// The numbers of the transitions that it may trigger.
    pub transitions: &'static [u8],
    /// The states in which it does nothing, even on a device that takes a wrong command for a fault.
    pub ignored_in: StateSet,
}

impl Command {
    /// A command that is given by the bits of a mask, in every state.
    pub const fn new(name: &'static str, mask: u16, value: u16, transitions: &'static [u8]) -> Self {
        let pattern = Pattern { mask, value };
        Self { name, pattern, edge: None, transitions, ignored_in: StateSet::NONE }
    }

    /// The same if it is given by a change of a bit.
    #[must_use]
    pub const fn on(self, edge: Edge) -> Self {
        Self { edge: Some(edge), ..self }
    }

    /// The same if it does nothing in some states.
    #[must_use]
    pub const fn ignored_in(self, states: StateSet) -> Self {
        Self { ignored_in: states, ..self }
    }

    /// Whether the step from the previous to the current controlword gives the command (CiA 402, command coding).
    #[inline]
    pub fn is_given(&self, previous: u16, current: u16) -> bool {
        self.pattern.matches(current) && self.edge.is_none_or(|edge| edge.happened(previous, current))
    }

    /// Whether it may trigger the transition of that number (CiA 402, command coding: transitions of a command).
    #[inline]
    pub const fn triggers(&self, number: u8) -> bool {
        // not `contains`, which calls a search for long runs of bytes
        let mut rest = self.transitions;
        while let [first, others @ ..] = rest {
            if *first == number {
                return true;
            }
            rest = others;
        }
        false
    }

    /// The controlword that gives the command, with all bits that it does not use as they are in `controlword`
    /// (CiA 402, command coding: bits marked as not relevant).
    #[inline]
    pub fn apply(&self, controlword: u16) -> u16 {
        let word = self.pattern.apply(controlword);
        self.edge.map_or(word, |edge| edge.after(word))
    }

    /// The controlword to send a cycle before [`apply`](Self::apply), so that an edge can happen.
    #[inline]
    pub fn prepare(&self, controlword: u16) -> u16 {
        self.edge.map_or(controlword, |edge| edge.before(controlword))
    }
}
