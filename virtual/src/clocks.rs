//! What a master has set of the distributed clocks.

use std::time::Duration;

/// The signals of the distributed clocks, as a master has activated them (ETG.1000.4, registers 0x0980 to 0x09A7).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Clocks {
    /// From one pulse of SYNC0 to the next, if there is SYNC0; 0 if there is one pulse only.
    pub sync0: Option<Duration>,
    /// The same of SYNC1.
    pub sync1: Option<Duration>,
    /// Whether they never come, as their start was in the past when they were activated.
    pub are_missed: bool,
}

impl Clocks {
    /// Whether there is any signal.
    pub const fn are_active(&self) -> bool {
        self.sync0.is_some() || self.sync1.is_some()
    }
}
