//! What makes or hinders a transition besides a command.

use super::Events;

/// The events that a transition depends on (CiA 402, PDS FSA transitions: automatic ones and their conditions).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Condition {
    /// The number of the transition.
    pub transition: u8,
    /// Any of them makes it without a command.
    pub causes: Events,
    /// While any of them holds, no command makes it.
    pub hinders: Events,
}

impl Condition {
    /// A transition that the drive makes by itself (CiA 402, PDS FSA transitions: automatic ones).
    pub const fn caused(transition: u8, causes: Events) -> Self {
        Self { transition, causes, hinders: Events::NONE }
    }

    /// A command that has to wait (Pilz 1005347, 6.5.2.4: enable signal).
    pub const fn hindered(transition: u8, hinders: Events) -> Self {
        Self { transition, causes: Events::NONE, hinders }
    }

    /// What CiA 402 says of all drives, first what goes first: a fault before a lockout, a lockout before the rest.
    ///
    /// A drive that stays in quick stop active never tells [`Events::QUICK_STOP_OVER`].
    pub const PROFILE: &'static [Self] = &[
        Self::caused(13, Events::FAULT),
        Self::caused(14, Events::FAULT_REACTION_OVER),
        Self::caused(1, Events::INITIALISED),
        Self::caused(12, Events::LOCKED_OUT.and(Events::QUICK_STOP_OVER)),
        Self::caused(9, Events::LOCKED_OUT),
        Self::caused(10, Events::LOCKED_OUT),
        Self::caused(7, Events::LOCKED_OUT),
        Self::hindered(2, Events::LOCKED_OUT),
        Self::hindered(15, Events::FAULT),
    ];
}
