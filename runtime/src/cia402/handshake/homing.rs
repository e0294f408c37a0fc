//! Finding the reference.

use crate::cia402::{Output, Timing};

/// The bits of homing in both words (CiA 402, homing mode).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct HomingBits {
    /// In the controlword: a rising edge starts, and the bit is held while homing lasts.
    pub start: u16,
    /// In the statusword: the drive has come to where it should, or to rest.
    pub reached: u16,
    /// In the statusword: the reference is set.
    pub attained: u16,
    /// In the statusword: homing has failed.
    pub error: u16,
}

impl HomingBits {
    /// Of CiA 402 (homing mode), of the C-887 (C887T0011, p. 15) and the Pilz drives (1005347, 6.6.9.2).
    pub const PROFILE: Self = Self { start: 1 << 4, reached: 1 << 10, attained: 1 << 12, error: 1 << 13 };
}

/// Starts homing and follows it to its end (CiA 402, homing mode).
///
/// A statusword that may be older than the start is not taken for its result: a reference of an earlier homing is none.
///
/// ```
/// use devc_runtime::cia402::{Homing, HomingBits, HomingProgress, Output, Progress, Timing};
///
/// let output = Output { controlword: 0x000F, mode: 6, seed: false, motion: true, progress: Progress::Reached };
/// let mut homing = Homing::new(HomingBits::PROFILE, Timing { round_trip: 1, ..Timing::DEFAULT });
/// homing.cycle(&output, 0x0637);
/// homing.start();
/// assert_eq!(homing.cycle(&output, 0x0637), 0x001F);
/// assert_eq!(homing.cycle(&output, 0x0237), 0x001F);
/// assert_eq!(homing.progress(), HomingProgress::Running);
/// assert_eq!(homing.cycle(&output, 0x1637), 0x000F);
/// assert_eq!(homing.progress(), HomingProgress::Completed);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Homing {
    bits: HomingBits,
    timing: Timing,
    progress: HomingProgress,
    /// Cycles since the start bit changed.
    cycles: u16,
    is_given: bool,
}

/// How far homing has come (CiA 402, homing mode, statusword bits 10, 12 and 13).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum HomingProgress {
    /// Not asked for.
    Idle,
    /// Asked for, but the drive does not show it yet.
    Starting,
    /// The drive looks for the reference.
    Running,
    /// The reference is set, and the drive stands.
    Completed,
    /// The drive reports an error; 0x603F may tell which.
    Failed,
    /// The drive ended it without a reference, or motion ended.
    Interrupted,
    /// No end in the time that was given.
    Overdue,
}

impl HomingProgress {
    /// Whether it is still to end.
    pub const fn is_active(self) -> bool {
        matches!(self, Self::Starting | Self::Running)
    }
}

impl Homing {
    /// Not asked for. The timing's timeout is for the whole of homing.
    pub const fn new(bits: HomingBits, timing: Timing) -> Self {
        Self { bits, timing, progress: HomingProgress::Idle, cycles: 0, is_given: false }
    }

    /// Asks for homing; begins once there is motion in homing mode, which the caller selects (CiA 402, homing mode,
    /// controlword bit 4).
    pub const fn start(&mut self) {
        self.progress = HomingProgress::Starting;
    }

    /// Ends homing, at whatever point: the start bit falls, on which a drive that keeps to the profile stops (CiA 402,
    /// homing mode). Its manual may say otherwise: where the bit only starts the run, another command has to stop it.
    pub const fn abort(&mut self) {
        if self.progress.is_active() {
            self.progress = HomingProgress::Interrupted;
        }
    }

    /// How far it has come.
    pub const fn progress(&self) -> HomingProgress {
        self.progress
    }

    /// One cycle: the controlword with the start bit.
    pub fn cycle(&mut self, output: &Output, statusword: u16) -> u16 {
        if !output.motion && self.is_given {
            self.abort();
        } else if self.is_given && self.progress.is_active() {
            self.progress = self.follow(statusword);
        }
        // an edge takes a bit that the drive has surely seen as 0
        let is_low = self.is_given || self.cycles >= self.timing.round_trip;
        let is_given = output.motion && self.progress.is_active() && is_low;
        self.cycles = if is_given == self.is_given { self.cycles.saturating_add(1) } else { 1 };
        self.is_given = is_given;
        if is_given { output.controlword | self.bits.start } else { output.controlword & !self.bits.start }
    }

    /// What a statusword says of a homing that was started (1005347, table 26).
    fn follow(&self, statusword: u16) -> HomingProgress {
        let is_set = |mask: u16| statusword & mask != 0;
        let is_answer = self.progress == HomingProgress::Running || self.cycles > self.timing.round_trip;
        match (is_set(self.bits.error), is_set(self.bits.attained), is_set(self.bits.reached)) {
            (false, false, false) if self.cycles < self.timing.timeout => HomingProgress::Running,
            (true, ..) if is_answer => HomingProgress::Failed,
            (false, true, true) if is_answer => HomingProgress::Completed,
            (false, false, true) if self.progress == HomingProgress::Running => HomingProgress::Interrupted,
            _ if self.cycles >= self.timing.timeout => HomingProgress::Overdue,
            _ => self.progress,
        }
    }
}
