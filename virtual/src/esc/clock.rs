//! Distributed clocks.

use super::Memory;
use super::registers as at;

/// From one subdevice to the next, in nanoseconds: the cable and the controller, once each way.
const HOP: u64 = 500;
/// The part of a difference that the clock makes up for at each comparison.
const CORRECTION: i64 = 4;

/// The clock of a subdevice (ETG.1000.4, distributed clocks). Time is told as it is on the wire, in nanoseconds.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Clock {
    /// How far the local time is ahead of that of the wire.
    ahead: u64,
    /// How many subdevices come before and behind it.
    before: u64,
    behind: u64,
    difference: i64,
}

impl Clock {
    /// The clock of the subdevice at a position. Each began at another time, as real ones do.
    pub(super) fn new(position: usize, count: usize) -> Self {
        let before = position as u64;
        let ahead = (before + 1).wrapping_mul(0x0000_0003_9E37_79B9);
        Self { ahead, before, behind: count.saturating_sub(position + 1) as u64, difference: 0 }
    }

    /// The local time at which a frame that was sent at `now` arrives.
    fn local(&self, now: u64) -> u64 {
        now.wrapping_add(self.before * HOP).wrapping_add(self.ahead)
    }

    fn system(&self, now: u64, memory: &Memory) -> u64 {
        self.local(now).wrapping_add(u64::from_le_bytes(memory.array(at::TIME_OFFSET)))
    }

    /// Brings the registers up to the time at which a frame passes.
    pub(super) fn show(&self, now: u64, memory: &mut Memory) {
        memory.put(at::SYSTEM_TIME, &self.system(now, memory).to_le_bytes());
        // bit 31 tells that the local copy is behind
        let behind = if self.difference < 0 { 0x8000_0000 } else { 0 };
        let size = u32::try_from(self.difference.unsigned_abs()).unwrap_or(u32::MAX) & 0x7FFF_FFFF;
        memory.put(at::TIME_DIFFERENCE, &(size | behind).to_le_bytes());
        if let Some(next) = self.next_sync0(now, memory) {
            memory.put(at::SYNC_START, &next.to_le_bytes());
        }
    }

    /// Keeps when a frame came, and when it came back from the subdevices behind.
    pub(super) fn latch(&self, now: u64, memory: &mut Memory) {
        let first = self.local(now);
        let back = if self.behind == 0 { 0 } else { first.wrapping_add(self.behind * 2 * HOP) };
        let [first_port, second_port] = [first, back].map(|time| (time & 0xFFFF_FFFF) as u32);
        memory.put(at::PORT_TIMES, &first_port.to_le_bytes());
        memory.put(at::PORT_TIMES + 4, &second_port.to_le_bytes());
        memory.put(at::RECEIVE_TIME, &first.to_le_bytes());
    }

    /// Compares the time with that of the reference clock, and follows it.
    pub(super) fn compare(&mut self, now: u64, reference: u32, memory: &Memory) {
        let delay = u32::from_le_bytes(memory.array(at::TIME_DELAY));
        let own = (self.system(now, memory) & 0xFFFF_FFFF) as u32;
        let difference = own.wrapping_sub(delay).wrapping_sub(reference).cast_signed();
        self.difference = difference.into();
        self.ahead = self.ahead.wrapping_add_signed(-(self.difference / CORRECTION));
    }

    /// Forgets the difference.
    pub(super) const fn restart(&mut self) {
        self.difference = 0;
    }

    /// The cycle of SYNC0 in nanoseconds, while it is active.
    pub(crate) fn sync0_cycle(memory: &Memory) -> Option<u32> {
        let is_active = memory.byte(at::SYNC_ACTIVATION) & 0x03 == 0x03;
        let cycle = u32::from_le_bytes(memory.array(at::SYNC0_CYCLE));
        (is_active && cycle != 0).then_some(cycle)
    }

    /// The time of the next pulse of SYNC0, while it is active.
    fn next_sync0(&self, now: u64, memory: &Memory) -> Option<u64> {
        let cycle = u64::from(Self::sync0_cycle(memory)?);
        let start = u64::from_le_bytes(memory.array(at::SYNC_START));
        let passed = self.system(now, memory).checked_sub(start)?;
        start.checked_add((passed.checked_div(cycle)? + 1).checked_mul(cycle)?)
    }
}
