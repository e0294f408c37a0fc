//! Distributed clocks.

use std::time::Duration;

use super::Memory;
use super::registers as at;
use super::signals::Signals;
use crate::Clocks;

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
    /// SYNC0 and SYNC1, while they are active.
    signals: Option<Signals>,
}

impl Clock {
    /// The clock of the subdevice at a position. Each began at another time, as real ones do.
    pub(super) fn new(position: usize, count: usize) -> Self {
        let before = position as u64;
        let ahead = (before + 1).wrapping_mul(0x0000_0003_9E37_79B9);
        Self {
            ahead,
            before,
            behind: count.saturating_sub(position + 1) as u64,
            difference: 0,
            signals: None,
        }
    }

    /// The local time at which a frame that was sent at `now` arrives.
    fn local(&self, now: u64) -> u64 {
        now.wrapping_add(self.before * HOP).wrapping_add(self.ahead)
    }

    /// The system time of a frame that was sent at `now`.
    pub(super) fn system(&self, now: u64, memory: &Memory) -> u64 {
        self.local(now).wrapping_add(u64::from_le_bytes(memory.array(at::TIME_OFFSET)))
    }

    /// Brings the registers up to the time at which a frame passes.
    pub(super) fn show(&self, now: u64, memory: &mut Memory) {
        memory.put(at::SYSTEM_TIME, &self.system(now, memory).to_le_bytes());
        // bit 31 tells that the local copy is behind
        let behind = if self.difference < 0 { 0x8000_0000 } else { 0 };
        let size = u32::try_from(self.difference.unsigned_abs()).unwrap_or(u32::MAX) & 0x7FFF_FFFF;
        memory.put(at::TIME_DIFFERENCE, &(size | behind).to_le_bytes());
        self.show_signals(now, memory);
    }

    fn show_signals(&self, now: u64, memory: &mut Memory) {
        let (time, [has_sync0, has_sync1]) = (self.system(now, memory), generated(memory));
        let signals = self.signals.as_ref();
        if let Some(next) = signals.filter(|_| has_sync0).and_then(|signals| signals.next_sync0(time)) {
            memory.put(at::SYNC_START, &next.to_le_bytes());
        }
        let next = signals.filter(|_| has_sync1).and_then(|signals| signals.next_sync1(time));
        memory.put(at::SYNC1_NEXT, &next.unwrap_or(0).to_le_bytes());
        memory.put(at::SYNC_STATUS, &[signals.map_or(0, |signals| signals.status(time))]);
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

    /// What activates the signals was written, or the start time that does so: they begin, go on, or end.
    pub(super) fn activate(&mut self, now: u64, memory: &Memory) {
        let is_active = memory.byte(at::SYNC_ACTIVATION) & ACTIVE != 0;
        let time = self.system(now, memory);
        let running = self.signals.take();
        self.signals = is_active.then(|| running.unwrap_or_else(|| Signals::activated(time, memory)));
    }

    /// What a master has set.
    pub(crate) fn clocks(&self, memory: &Memory) -> Clocks {
        let [has_sync0, has_sync1] = generated(memory);
        let signals = self.signals.as_ref();
        Clocks {
            sync0: signals.filter(|_| has_sync0).map(|it| Duration::from_nanos(it.sync0_cycle())),
            sync1: signals.filter(|_| has_sync1).map(|it| Duration::from_nanos(it.sync1_cycle())),
            are_missed: signals.is_some_and(Signals::are_missed),
        }
    }
}

/// Bits of the register that activates the signals: all of them, and with the start time.
pub(super) const ACTIVE: u8 = 0x01;
pub(super) const BY_START_TIME: u8 = 0x08;

/// Whether SYNC0 and SYNC1 are asked for.
fn generated(memory: &Memory) -> [bool; 2] {
    let activation = memory.byte(at::SYNC_ACTIVATION);
    [activation & 0x02 != 0, activation & 0x04 != 0]
}
