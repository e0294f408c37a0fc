//! SYNC0 and SYNC1: what a clock tells the firmware, at times that a master sets.

use super::Memory;
use super::registers as at;

/// The signals of a clock since they were activated (ETG.1000.4, distributed clocks), in nanoseconds of the system time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Signals {
    /// The first pulse of SYNC0.
    start: u64,
    /// From one pulse of SYNC0 to the next; 0 if there is one only.
    cycle: u64,
    /// From a pulse of SYNC0 to the one of SYNC1 that follows it.
    delay: u64,
    /// Whether the first pulse lay in the past: then none comes.
    is_missed: bool,
}

impl Signals {
    /// As the registers have them when they are activated.
    pub(super) fn activated(time: u64, memory: &Memory) -> Self {
        let start = u64::from_le_bytes(memory.array(at::SYNC_START));
        Self {
            start,
            cycle: u32::from_le_bytes(memory.array(at::SYNC0_CYCLE)).into(),
            delay: u32::from_le_bytes(memory.array(at::SYNC1_CYCLE)).into(),
            is_missed: start < time,
        }
    }

    /// The next pulse of SYNC0; none behind a single one.
    pub(super) fn next_sync0(&self, time: u64) -> Option<u64> {
        self.next(self.start, self.cycle, time)
    }

    /// The next pulse of SYNC1; none behind a single one.
    pub(super) fn next_sync1(&self, time: u64) -> Option<u64> {
        self.next(self.start.checked_add(self.delay)?, self.sync1_cycle(), time)
    }

    /// From one pulse of SYNC0 to the next; 0 if there is one only.
    pub(super) const fn sync0_cycle(&self) -> u64 {
        self.cycle
    }

    /// From one pulse of SYNC1 to the next: while one is due, further pulses of SYNC0 have none.
    pub(super) fn sync1_cycle(&self) -> u64 {
        self.delay.checked_div(self.cycle).map_or(0, |times| (times + 1) * self.cycle)
    }

    /// Whether they never come, as the time to begin had gone by.
    pub(super) const fn are_missed(&self) -> bool {
        self.is_missed
    }

    /// The register activation status: whether SYNC0 and SYNC1 are still to come, and whether the start was in the past.
    pub(super) fn status(&self, time: u64) -> u8 {
        let is_pending = |first: u64| self.is_missed || time < first;
        u8::from(is_pending(self.start))
            | u8::from(is_pending(self.start.saturating_add(self.delay))) << 1
            | u8::from(self.is_missed) << 2
    }

    /// The first of some times that is to come: one, and each a period behind the last.
    fn next(&self, first: u64, period: u64, time: u64) -> Option<u64> {
        if self.is_missed {
            return None;
        }
        let Some(passed) = time.checked_sub(first) else { return Some(first) };
        let times = passed.checked_div(period)?.checked_add(1)?;
        times.checked_mul(period)?.checked_add(first)
    }
}
