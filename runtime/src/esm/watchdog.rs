//! Whether outputs come in time.

/// The watchdog of process data (ETG.1000.4, watchdog).
///
/// ```
/// use devc_runtime::esm::Watchdog;
///
/// // the registers as they are after a reset: 100 ms
/// let mut watchdog = Watchdog::of_registers(2498, 1000);
/// assert_eq!(watchdog.timeout_ns(), 100_000_000);
/// assert!(!watchdog.elapse(99_999_999));
/// watchdog.feed();
/// assert!(!watchdog.elapse(99_999_999));
/// assert!(watchdog.elapse(1));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Watchdog {
    timeout_ns: u64,
    since_ns: u64,
}

impl Watchdog {
    /// A watchdog of this time; 0 switches it off.
    pub const fn new(timeout_ns: u64) -> Self {
        Self { timeout_ns, since_ns: 0 }
    }

    /// The watchdog that the registers 0x0400, the divider, and 0x0420, the time of process data, set: a count of 40 ns times
    /// the divider and two.
    pub const fn of_registers(divider: u16, time: u16) -> Self {
        Self::new(40 * (divider as u64 + 2) * time as u64)
    }

    /// The time after which it expires; 0 if it is off.
    pub const fn timeout_ns(self) -> u64 {
        self.timeout_ns
    }

    /// Outputs have come.
    pub const fn feed(&mut self) {
        self.since_ns = 0;
    }

    /// Time has passed; tells whether the watchdog has expired.
    #[must_use = "an expired watchdog takes the device out of Operational"]
    pub const fn elapse(&mut self, ns: u64) -> bool {
        self.since_ns = self.since_ns.saturating_add(ns);
        self.timeout_ns != 0 && self.since_ns >= self.timeout_ns
    }
}
