//! The mode of operation on the side of the drive.

use super::{Modes, Refusal, State};

/// Goes from mode to mode as a device does (CiA 402, modes of operation 0x6060 and display 0x6061).
///
/// ```
/// use devc_runtime::cia402::{ModeStep, ModeSwitch, Running, State, generic};
///
/// let mut mode = ModeSwitch::new(&generic::MODES);
/// // asked for, while the drive still moves, then at rest
/// assert_eq!(mode.cycle(8, State::SwitchedOn, Running::Busy), ModeStep::Pending);
/// assert_eq!(mode.display(), 0);
/// assert_eq!(mode.cycle(8, State::SwitchedOn, Running::Over), ModeStep::Changed { from: 0, to: 8 });
/// assert_eq!(mode.display(), 8);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct ModeSwitch {
    modes: &'static Modes,
    display: i8,
}

/// How far what the drive does in its present mode has come, when another mode is asked for (C887T0011, p. 11).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Running {
    /// It is not over: the drive moves, or has still to get ready.
    Busy,
    /// It is over, the mode may change.
    Over,
    /// It has failed, so that the change fails.
    Failed,
}

/// What became of the mode in a cycle (CiA 402, modes of operation display 0x6061).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ModeStep {
    /// The mode that is asked for is the one that is displayed.
    Steady,
    /// A change is asked for that cannot be made yet.
    Pending,
    /// The mode has changed.
    Changed {
        /// The number before.
        from: i8,
        /// The number after.
        to: i8,
    },
    /// The device does not make that change, and leaves it at that.
    Ignored {
        /// The number that was asked for.
        asked: i8,
    },
    /// The change failed, no mode is displayed: the drive has to be told of a fault
    /// ([`Events::FAULT`](super::Events::FAULT)).
    Failed {
        /// The number that was asked for.
        asked: i8,
    },
}

impl ModeSwitch {
    /// No mode yet.
    pub const fn new(modes: &'static Modes) -> Self {
        Self { modes, display: 0 }
    }

    /// The number for the display object 0x6061.
    pub const fn display(&self) -> i8 {
        self.display
    }

    /// Back to no mode, as some devices do when they have stopped (C887T0011, p. 17).
    pub const fn clear(&mut self) {
        self.display = 0;
    }

    /// One cycle with the number in 0x6060.
    pub fn cycle(&mut self, asked: i8, state: State, running: Running) -> ModeStep {
        if asked == self.display {
            return ModeStep::Steady;
        }
        if !self.modes.are_selectable_in(state) {
            return ModeStep::Pending;
        }
        match (self.modes.allows(self.display, asked), running) {
            (true, Running::Over) => {
                let from = core::mem::replace(&mut self.display, asked);
                ModeStep::Changed { from, to: asked }
            }
            (true, Running::Busy) => ModeStep::Pending,
            (true, Running::Failed) => self.fail(asked),
            (false, _) if self.modes.refusal == Refusal::Fault => self.fail(asked),
            (false, _) => ModeStep::Ignored { asked },
        }
    }

    const fn fail(&mut self, asked: i8) -> ModeStep {
        self.display = 0;
        ModeStep::Failed { asked }
    }
}
