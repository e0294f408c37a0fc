//! Whether the master sends outputs in time.

use devc_runtime::esm::Watchdog;

use super::Memory;
use super::registers as at;

/// The watchdog of process data. It runs once outputs have come that feed it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ProcessWatchdog {
    watchdog: Watchdog,
    state: State,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// No outputs have come that feed it.
    Idle,
    Running,
    Expired,
}

impl ProcessWatchdog {
    pub(super) const fn new() -> Self {
        Self { watchdog: Watchdog::new(0), state: State::Idle }
    }

    /// Takes what a master wrote into the registers.
    pub(super) fn configure(&mut self, memory: &Memory) {
        let time = memory.word(at::WATCHDOG_TIME);
        self.watchdog = Watchdog::of_registers(memory.word(at::WATCHDOG_DIVIDER), time);
    }

    /// Outputs have come.
    pub(super) const fn feed(&mut self) {
        self.watchdog.feed();
        self.state = State::Running;
    }

    /// There are no outputs to wait for any more.
    pub(super) const fn stop(&mut self) {
        self.state = State::Idle;
    }

    /// Time goes on. The counter of the registers counts how often it has expired.
    pub(super) fn elapse(&mut self, ns: u64, memory: &mut Memory) {
        if self.state == State::Running && self.watchdog.elapse(ns) {
            self.state = State::Expired;
            let count = memory.byte(0x0442).saturating_add(1);
            memory.put(0x0442, &[count]);
        }
    }

    pub(crate) fn is_expired(&self) -> bool {
        self.state == State::Expired
    }

    pub(crate) const fn timeout_ns(&self) -> u64 {
        self.watchdog.timeout_ns()
    }

    /// Brings the register up to date: 1 while it runs, or if it is off.
    pub(super) fn show(&self, memory: &mut Memory) {
        let is_well = self.state == State::Running || self.watchdog.timeout_ns() == 0;
        memory.put(at::WATCHDOG_STATUS, &[is_well.into(), 0]);
    }
}
