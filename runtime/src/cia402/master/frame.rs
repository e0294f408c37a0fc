//! What goes in and out of a master each cycle.

use super::Progress;

/// What came from the drive last, and what the caller did with [`Output::seed`] (CiA 402, statusword 0x6041 and modes of
/// operation display 0x6061).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Feedback {
    /// The statusword, 0x6041.
    pub statusword: u16,
    /// The displayed mode, 0x6061; where it is not in the process data, what an SDO read last.
    pub mode: i8,
    /// Whether the targets that go out with the next controlword are at the actual values.
    pub seeded: bool,
}

/// What is to be sent, and what the caller may do (CiA 402, controlword 0x6040 and modes of operation 0x6060).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Output {
    /// The controlword, 0x6040, with the bits of the mode 0.
    pub controlword: u16,
    /// The mode, 0x6060.
    pub mode: i8,
    /// The targets have to be set to the actual values, so that the drive does not jump when it is enabled.
    pub seed: bool,
    /// The drive follows its targets in the mode that was asked for. Never together with `seed`.
    pub motion: bool,
    /// How far the request has come.
    pub progress: Progress,
}

/// How long the master waits, in cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Timing {
    /// From a controlword until the statusword that answers it, at the most. A fault reset is held that long.
    pub round_trip: u16,
    /// From an edge until it is given again, because it was lost or the drive could not follow. Longer than any
    /// transition takes.
    pub resend: u16,
    /// For anything, until the request is given up.
    pub timeout: u16,
}

impl Timing {
    /// For cycles of a millisecond: 8 ms for the answer, 0.5 s for a transition, 5 s until giving up.
    pub const DEFAULT: Self = Self { round_trip: 8, resend: 500, timeout: 5000 };
}
