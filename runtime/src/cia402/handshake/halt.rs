//! Stopping within a mode.

use crate::cia402::Timing;

const HALT: u16 = 1 << 8;
const TARGET_REACHED: u16 = 1 << 10;

/// Stops an axis without leaving its mode (CiA 402, controlword bit 8, halt; C887T0011, p. 15, in homing).
///
/// While halt is given, bit 10 of the statusword tells whether the axis stands. Not every mode has the bit: on the C-887
/// it is reserved in CSP, where the targets are to be stopped instead (C887T0011, p. 12).
///
/// ```
/// use devc_runtime::cia402::{Halt, HaltProgress, Timing};
///
/// let mut halt = Halt::new(Timing { round_trip: 2, ..Timing::DEFAULT });
/// halt.give(true);
/// assert_eq!(halt.cycle(0x000F, 0x0637), 0x010F);
/// // bit 10 is of the motion before, until the drive can have answered
/// assert_eq!(halt.progress(), HaltProgress::Stopping);
/// halt.cycle(0x000F, 0x0237);
/// halt.cycle(0x000F, 0x0637);
/// assert_eq!(halt.progress(), HaltProgress::Standing);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Halt {
    timing: Timing,
    given: bool,
    cycles: u16,
    stands: bool,
}

/// How far a halt has come (CiA 402, statusword bit 10 with halt).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum HaltProgress {
    /// No halt is given.
    Released,
    /// The axis slows down.
    Stopping,
    /// The axis stands.
    Standing,
}

impl Halt {
    /// Not given.
    pub const fn new(timing: Timing) -> Self {
        Self { timing, given: false, cycles: 0, stands: false }
    }

    /// Gives halt, or takes it back.
    pub const fn give(&mut self, halt: bool) {
        if halt != self.given {
            (self.given, self.cycles, self.stands) = (halt, 0, false);
        }
    }

    /// How far it has come.
    pub const fn progress(&self) -> HaltProgress {
        match (self.given, self.stands) {
            (false, _) => HaltProgress::Released,
            (true, false) => HaltProgress::Stopping,
            (true, true) => HaltProgress::Standing,
        }
    }

    /// One cycle: the controlword with the bit. It may be given whether the drive is enabled or not.
    pub const fn cycle(&mut self, controlword: u16, statusword: u16) -> u16 {
        if !self.given {
            return controlword & !HALT;
        }
        self.stands = self.cycles >= self.timing.round_trip && statusword & TARGET_REACHED != 0;
        self.cycles = self.cycles.saturating_add(1);
        controlword | HALT
    }
}
