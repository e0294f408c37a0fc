//! Set-points of profile position mode, one after the other.

use crate::cia402::{Output, Timing};

const NEW_SET_POINT: u16 = 1 << 4;
const CHANGE_IMMEDIATELY: u16 = 1 << 5;
const RELATIVE: u16 = 1 << 6;
const TARGET_REACHED: u16 = 1 << 10;
const ACKNOWLEDGE: u16 = 1 << 12;

/// Hands set-points to a drive in profile position mode (CiA 402, profile position mode, single set-points; Pilz
/// 1005347, 6.6.5.2): the bit new set-point rises, the drive acknowledges, the bit falls, the drive is free again.
///
/// No set-point is lost or taken twice, however late the answers are: each step waits for the drive's.
///
/// ```
/// use devc_runtime::cia402::{Move, Output, Progress, SetPointProgress, SetPoints, Timing};
///
/// let output = Output { controlword: 0x000F, mode: 1, seed: false, motion: true, progress: Progress::Reached };
/// let mut points = SetPoints::new(Timing::DEFAULT);
/// assert!(points.offer(Move::ABSOLUTE)); // with the target position
/// assert_eq!(points.cycle(&output, 0x0437), 0x001F);
/// assert_eq!(points.cycle(&output, 0x1037), 0x000F);
/// assert!(!points.offer(Move::ABSOLUTE), "the drive still acknowledges the last");
/// points.cycle(&output, 0x0037);
/// assert_eq!(points.progress(), SetPointProgress::Travelling);
/// points.cycle(&output, 0x0437);
/// assert_eq!(points.progress(), SetPointProgress::Arrived);
/// ```
#[derive(Debug, Clone, Copy)]
pub struct SetPoints {
    timing: Timing,
    progress: SetPointProgress,
    kind: Move,
    /// Cycles since `progress` changed.
    cycles: u16,
    /// Cycles since the bit new set-point fell; many if the drive is known to have seen it.
    low: u16,
}

/// What a set-point means (CiA 402, profile position mode, controlword bits 5 and 6).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Move {
    /// The target is a distance, not a position (bit 6).
    pub relative: bool,
    /// It replaces the one that the drive travels to, instead of following it (bit 5).
    pub immediate: bool,
}

impl Move {
    /// To a position, after what went before.
    pub const ABSOLUTE: Self = Self { relative: false, immediate: false };

    const fn bits(self) -> u16 {
        let relative = if self.relative { RELATIVE } else { 0 };
        relative | if self.immediate { CHANGE_IMMEDIATELY } else { 0 }
    }
}

/// How far a set-point has come (CiA 402, profile position mode, statusword bits 10 and 12).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SetPointProgress {
    /// There is none.
    Free,
    /// Waits for the drive to be ready for it; the target has to stay as it is.
    Offered,
    /// Given; the drive has not acknowledged it yet, and the target has to stay as it is.
    Given,
    /// Acknowledged; the drive cannot take another yet.
    Acknowledged,
    /// The drive travels to it; another may be offered.
    Travelling,
    /// The drive has arrived; another may be offered.
    Arrived,
    /// Motion ended before it was reached.
    Interrupted,
    /// The drive did not answer in time.
    Overdue,
}

impl SetPoints {
    /// None yet.
    pub const fn new(timing: Timing) -> Self {
        Self { timing, progress: SetPointProgress::Free, kind: Move::ABSOLUTE, cycles: 0, low: u16::MAX }
    }

    /// Offers the set-point that the targets hold from now on; `false` while the last one is still to be taken.
    pub const fn offer(&mut self, kind: Move) -> bool {
        let is_free = !self.is_pending();
        if is_free {
            (self.progress, self.kind, self.cycles) = (SetPointProgress::Offered, kind, 0);
        }
        is_free
    }

    /// How far the last one has come.
    pub const fn progress(&self) -> SetPointProgress {
        self.progress
    }

    /// One cycle: the controlword with the bits of the set-point.
    pub fn cycle(&mut self, output: &Output, statusword: u16) -> u16 {
        let next = if output.motion { self.follow(statusword) } else { self.stopped() };
        self.cycles = if next == self.progress { self.cycles.saturating_add(1) } else { 0 };
        self.progress = next;
        if self.is_pending() && self.cycles >= self.timing.timeout {
            self.progress = SetPointProgress::Overdue;
        }
        let controlword = output.controlword & !(NEW_SET_POINT | CHANGE_IMMEDIATELY | RELATIVE);
        if self.progress == SetPointProgress::Given {
            self.low = 0;
            return controlword | NEW_SET_POINT | self.kind.bits();
        }
        let is_seen = self.progress == SetPointProgress::Travelling;
        self.low = if is_seen { u16::MAX } else { self.low.saturating_add(1) };
        controlword
    }

    const fn is_pending(&self) -> bool {
        use SetPointProgress::{Acknowledged, Given, Offered};
        matches!(self.progress, Offered | Given | Acknowledged)
    }

    const fn follow(&self, statusword: u16) -> SetPointProgress {
        let is_acknowledged = statusword & ACKNOWLEDGE != 0;
        let has_arrived = statusword & TARGET_REACHED != 0;
        match self.progress {
            SetPointProgress::Offered if !is_acknowledged && self.low >= self.timing.round_trip => {
                SetPointProgress::Given
            }
            SetPointProgress::Given if is_acknowledged => SetPointProgress::Acknowledged,
            SetPointProgress::Acknowledged if !is_acknowledged => SetPointProgress::Travelling,
            SetPointProgress::Travelling if has_arrived => SetPointProgress::Arrived,
            other => other,
        }
    }

    /// One that was offered still waits for motion.
    const fn stopped(&self) -> SetPointProgress {
        use SetPointProgress::{Acknowledged, Given, Interrupted, Travelling};
        match self.progress {
            Given | Acknowledged | Travelling => Interrupted,
            other => other,
        }
    }
}
