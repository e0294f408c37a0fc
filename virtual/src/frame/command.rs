//! What a datagram asks for.

/// Where a datagram leads, each way with what its four bytes of address mean (ETG.1000.4, addressing).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Target {
    /// The subdevice at which the position, counted up by each on the way, is 0.
    Position,
    /// The subdevice with the station address, or with the alias.
    Station,
    /// All.
    Broadcast,
    /// Whatever is mapped there by FMMUs.
    Logical,
}

/// A command by its number (ETG.1000.4, DLPDU types). `NOP` is none, nor is a number that there is not: both pass through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Command {
    pub(crate) target: Target,
    pub(crate) reads: bool,
    pub(crate) writes: bool,
    /// The addressed one is read, and all others are written with that.
    pub(crate) is_multiple: bool,
}

impl Command {
    pub(crate) const fn of(number: u8) -> Option<Self> {
        use Target::{Broadcast, Logical, Position, Station};
        let (target, reads, writes) = match number {
            1 => (Position, true, false),
            2 => (Position, false, true),
            3 | 13 => (Position, true, true),
            4 => (Station, true, false),
            5 => (Station, false, true),
            6 | 14 => (Station, true, true),
            7 => (Broadcast, true, false),
            8 => (Broadcast, false, true),
            9 => (Broadcast, true, true),
            10 => (Logical, true, false),
            11 => (Logical, false, true),
            12 => (Logical, true, true),
            _ => return None,
        };
        Some(Self { target, reads, writes, is_multiple: matches!(number, 13 | 14) })
    }
}
