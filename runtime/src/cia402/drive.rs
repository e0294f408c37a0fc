//! The state machine of one axis, on the side of the drive.

use super::{Events, Machine, State, Step};

/// What a firmware runs for an axis: the controlword goes in each cycle, the statusword comes out (CiA 402, PDS FSA).
///
/// Commands with an edge count once, however long their bit is held; the first word after power-on gives no rising
/// edge. While the communication is down, the word that was received last is to be given.
///
/// ```
/// use devc_runtime::cia402::{Drive, Events, State, generic};
///
/// let mut drive = Drive::new(&generic::MACHINE);
/// drive.cycle(0x0000, Events::INITIALISED);
/// for controlword in [0x0006, 0x0007, 0x000F] {
///     drive.cycle(controlword, Events::NONE);
/// }
/// assert_eq!(drive.state(), State::OperationEnabled);
/// assert_eq!(drive.statusword(0x0610), 0x0637);
///
/// // a fault, its reaction, and a reset that is held: no second one
/// drive.cycle(0x000F, Events::FAULT);
/// drive.cycle(0x008F, Events::FAULT_REACTION_OVER);
/// drive.cycle(0x008F, Events::NONE);
/// assert_eq!(drive.state(), State::Fault);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Drive {
    machine: &'static Machine,
    state: State,
    controlword: u16,
}

impl Drive {
    /// Just switched on, after transition 0.
    pub const fn new(machine: &'static Machine) -> Self {
        // every bit set, so that the first word gives no rising edge
        Self { machine, state: State::NotReadyToSwitchOn, controlword: u16::MAX }
    }

    /// The state now.
    pub const fn state(&self) -> State {
        self.state
    }

    /// One cycle: what is asked for, and what holds besides. The transition that was made, if one was.
    #[inline]
    pub fn cycle(&mut self, controlword: u16, events: Events) -> Option<Step> {
        let previous = core::mem::replace(&mut self.controlword, controlword);
        let step = self.machine.step(self.state, (previous, controlword), events)?;
        self.state = step.to;
        Some(step)
    }

    /// The statusword: the bits of the state as the device shows them, all others as given.
    #[inline]
    pub fn statusword(&self, other_bits: u16) -> u16 {
        self.machine.states.show(self.state, other_bits)
    }

    /// In that state, with that word received last: for a drive that starts again where it was.
    #[must_use]
    pub const fn resumed(self, state: State, controlword: u16) -> Self {
        Self { machine: self.machine, state, controlword }
    }
}
