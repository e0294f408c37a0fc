//! Inputs whose edges are kept with their time.

use std::ops::Range;

use super::Memory;
use super::registers as at;

/// The bytes of a time.
const TIME: u16 = 8;

/// A latch (ETG.1000.4, distributed clocks, latch): a rising and a falling edge.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Latch {
    is_high: bool,
    /// Whether an edge was seen whose time nobody has read, of each kind.
    is_seen: [bool; 2],
}

impl Latch {
    /// The input of latch `number` has another level, at a system time. An edge that is asked for once is kept until its time
    /// was read; else the last one counts.
    pub(super) fn change(&mut self, number: u16, is_high: bool, time: u64, memory: &mut Memory) {
        if std::mem::replace(&mut self.is_high, is_high) == is_high {
            return;
        }
        let control = memory.byte(at::LATCH_CONTROL + number);
        let (edge, is_single) = if is_high { (0, control & 0x01 != 0) } else { (1, control & 0x02 != 0) };
        let Some(is_seen) = self.is_seen.get_mut(usize::from(edge)) else { return };
        if !(is_single && *is_seen) {
            *is_seen = true;
            memory.put(place(number, edge), &time.to_le_bytes());
        }
    }

    /// Brings the status up to date.
    pub(super) fn show(&self, number: u16, memory: &mut Memory) {
        let [rising, falling] = self.is_seen;
        let status = u8::from(rising) | u8::from(falling) << 1 | u8::from(self.is_high) << 2;
        memory.put(at::LATCH_STATUS + number, &[status]);
    }

    /// A master has read these registers: a time that was among them makes room for another.
    pub(super) fn was_read(&mut self, number: u16, read: &Range<u32>) {
        for (edge, is_seen) in (0..).zip(&mut self.is_seen) {
            *is_seen &= !read.contains(&place(number, edge).into());
        }
    }

    /// Whether there is something for a master to read.
    pub(super) fn is_pending(&self) -> bool {
        self.is_seen.contains(&true)
    }
}

/// Where the time of an edge is.
const fn place(number: u16, edge: u16) -> u16 {
    at::LATCH_TIMES + (2 * number + edge) * TIME
}
