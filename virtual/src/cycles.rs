//! How regularly a master sends process data.

use std::time::Duration;

/// The times between outputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Cycles {
    last: Option<u64>,
    count: u32,
    sum: u64,
    shortest: u64,
    longest: u64,
}

impl Cycles {
    /// Outputs came, so many nanoseconds after the device was switched on.
    pub(crate) fn count(&mut self, at: u64) {
        if let Some(last) = self.last {
            let cycle = at.saturating_sub(last);
            self.shortest = if self.count == 0 { cycle } else { self.shortest.min(cycle) };
            self.longest = self.longest.max(cycle);
            self.sum = self.sum.saturating_add(cycle);
            self.count = self.count.saturating_add(1);
        }
        self.last = Some(at);
    }

    /// There is no process data any more.
    pub(crate) const fn stop(&mut self) {
        self.last = None;
    }

    /// What was counted; it begins anew.
    pub(crate) const fn take(&mut self) -> Self {
        let taken = *self;
        *self = Self { last: self.last, count: 0, sum: 0, shortest: 0, longest: 0 };
        taken
    }

    /// How many there were.
    pub const fn number(&self) -> u32 {
        self.count
    }

    /// The mean; none if there was none.
    pub fn mean(&self) -> Option<Duration> {
        self.sum.checked_div(self.count.into()).map(Duration::from_nanos)
    }

    /// The shortest.
    pub const fn shortest(&self) -> Duration {
        Duration::from_nanos(self.shortest)
    }

    /// The longest.
    pub const fn longest(&self) -> Duration {
        Duration::from_nanos(self.longest)
    }
}
