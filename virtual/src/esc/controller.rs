//! The parts of a controller, and how registers set them.

use std::ops::Range;

use devc_runtime::esm::{AlStatus, AlStatusCode, Configured};

use super::clock::{self, Clock};
use super::eeprom::Eeprom;
use super::latch::Latch;
use super::registers as at;
use super::watchdog::ProcessWatchdog;
use super::{Fmmu, Memory, SyncManager};
use crate::Clocks;
use crate::event::Event;

/// Kind, revision, build, numbers of FMMUs and sync managers, KiB of memory, two ports with Ethernet, and what it can: 64-bit
/// distributed clocks, the states of links, checksums of each port. As widespread controllers have it.
const KIND: [u8; 10] = [0x11, 0, 2, 0, 8, 8, 8, 0x0F, 0xCC, 0];

/// A controller as the wire and the firmware see it. Time is told in nanoseconds since it was switched on.
#[derive(Debug)]
pub(crate) struct Controller {
    pub(crate) memory: Memory,
    pub(crate) managers: [SyncManager; at::COUNT as usize],
    pub(super) fmmus: [Fmmu; at::COUNT as usize],
    pub(super) clock: Clock,
    pub(super) latches: [Latch; 2],
    pub(super) eeprom: Eeprom,
    pub(crate) watchdog: ProcessWatchdog,
    pub(super) now: u64,
    /// What a master wrote into AL control, until the firmware has taken it.
    pub(crate) al_control: Option<u16>,
    /// What is to be told.
    pub(crate) events: Vec<Event>,
    /// When complete outputs came last.
    pub(crate) outputs_at: Option<u64>,
}

impl Controller {
    /// A controller with the image of its EEPROM, and memory up to an address at least.
    pub(crate) fn new(image: Vec<u8>, end: u32) -> Self {
        let ram_kib = end.saturating_sub(at::RAM.into()).div_ceil(1024).clamp(8, 60);
        let ram_kib = u8::try_from(ram_kib).unwrap_or(60);
        let mut memory = Memory::new(ram_kib);
        memory.put(at::TYPE, &KIND);
        memory.put(at::TYPE + 6, &[ram_kib]);
        memory.put(at::DL_CONTROL, &[0x01, 0xC0, 0x07, 0]);
        memory.put(at::WATCHDOG_DIVIDER, &2498_u16.to_le_bytes());
        memory.put(at::PDI_WATCHDOG_TIME, &1000_u16.to_le_bytes());
        memory.put(at::WATCHDOG_TIME, &1000_u16.to_le_bytes());
        let mut eeprom = Eeprom::new(image);
        eeprom.load(&mut memory);
        let mut watchdog = ProcessWatchdog::new();
        watchdog.configure(&memory);
        let mut controller = Self {
            memory,
            managers: [SyncManager::new(); at::COUNT as usize],
            fmmus: [Fmmu::default(); at::COUNT as usize],
            clock: Clock::new(0, 1),
            latches: Default::default(),
            eeprom,
            watchdog,
            now: 0,
            al_control: None,
            events: Vec::new(),
            outputs_at: None,
        };
        controller.place(0, 1);
        controller
    }

    /// Puts it on a wire: at a position, among so many.
    pub(crate) fn place(&mut self, position: usize, count: usize) {
        self.clock = Clock::new(position, count);
        // a link and a port that is open towards the master, and another one if there are subdevices behind
        let ports: u16 = if position + 1 < count { 0x5A30 } else { 0x5610 };
        let status = ports | u16::from(self.eeprom.is_loaded());
        self.memory.put(at::DL_STATUS, &status.to_le_bytes());
    }

    /// Time goes on.
    pub(crate) fn elapse(&mut self, ns: u64) {
        self.now = self.now.wrapping_add(ns);
        self.eeprom.elapse(ns, &mut self.memory);
        self.watchdog.elapse(ns, &mut self.memory);
    }

    /// Process data is no longer exchanged.
    pub(crate) const fn stop(&mut self) {
        self.watchdog.stop();
        self.outputs_at = None;
    }

    /// What AL status and AL status code show from now on.
    pub(crate) fn show_status(&mut self, status: AlStatus, code: AlStatusCode) {
        self.memory.put(at::AL_STATUS, &status.0.to_le_bytes());
        self.memory.put(at::AL_STATUS_CODE, &code.0.to_le_bytes());
    }

    /// The settings of the sync managers, by number.
    pub(crate) fn settings(&self) -> [Configured; at::COUNT as usize] {
        self.managers.each_ref().map(SyncManager::settings)
    }

    /// What is in the EEPROM.
    pub(crate) fn image(&self) -> Vec<u8> {
        self.eeprom.image().to_vec()
    }

    /// What a master has set of the clock.
    pub(crate) fn clocks(&self) -> Clocks {
        self.clock.clocks(&self.memory)
    }

    /// The level at the input of a latch is another, if there is such a latch.
    pub(crate) fn latch(&mut self, number: u16, is_high: bool) {
        let time = self.clock.system(self.now, &self.memory);
        if let Some(latch) = self.latches.get_mut(usize::from(number)) {
            latch.change(number, is_high, time, &mut self.memory);
        }
    }

    /// Brings those registers up to date that are not memory, before they are read.
    pub(super) fn show(&mut self, read: &Range<u32>) {
        let is_read = |first: u16, length: u16| overlaps(read, first, length);
        if is_read(at::EVENT_REQUEST, 2) {
            let request = self.event_request();
            self.memory.put(at::EVENT_REQUEST, &request.to_le_bytes());
        }
        if is_read(at::WATCHDOG_STATUS, 2) {
            self.watchdog.show(&mut self.memory);
        }
        if is_read(at::MANAGERS, at::MANAGER_SIZE * at::COUNT) {
            for (manager, first) in self.managers.iter().zip((at::MANAGERS..).step_by(8)) {
                self.memory.put(first + 5, &manager.status());
            }
        }
        if is_read(at::PORT_TIMES, at::CLOCKS_END - at::PORT_TIMES) {
            self.clock.show(self.now, &mut self.memory);
            for (number, latch) in (0..).zip(&self.latches) {
                latch.show(number, &mut self.memory);
            }
        }
    }

    /// Does what follows from registers that a master has read.
    pub(super) fn registers_read(&mut self, read: &Range<u32>) {
        for (number, latch) in (0..).zip(&mut self.latches) {
            latch.was_read(number, read);
        }
    }

    /// What there is for a master to do: an edge at a latch, and sync managers.
    pub(super) fn event_request(&self) -> u16 {
        let latched = u16::from(self.latches.iter().any(Latch::is_pending));
        let pending = self.managers.iter().zip(4..).filter(|(manager, _)| manager.is_pending());
        pending.fold(latched, |request, (_, bit)| request | 1 << bit)
    }

    /// Does what follows from registers that a master has written.
    pub(super) fn registers_written(&mut self, written: &Range<u32>) {
        let is_written = |first: u16, length: u16| overlaps(written, first, length);
        if is_written(at::AL_CONTROL, 2) {
            self.al_control = Some(self.memory.word(at::AL_CONTROL));
        }
        if is_written(at::ERROR_COUNTERS, 20) {
            self.memory.put(at::ERROR_COUNTERS, &[0; 20]);
        }
        if is_written(0x0442, 2) {
            self.memory.put(0x0442, &[0; 2]);
        }
        if is_written(at::WATCHDOG_DIVIDER, 0x22) {
            self.watchdog.configure(&self.memory);
        }
        if is_written(at::EEPROM_CONTROL, 2) && !self.eeprom.is_locked(&self.memory) {
            self.eeprom.command(&mut self.memory);
        }
        if is_written(at::FMMUS, at::FMMU_SIZE * at::COUNT) {
            for (fmmu, first) in self.fmmus.iter_mut().zip((at::FMMUS..).step_by(16)) {
                *fmmu = Fmmu::from_registers(self.memory.array(first));
            }
        }
        if is_written(at::MANAGERS, at::MANAGER_SIZE * at::COUNT) {
            self.managers_written();
        }
        if is_written(at::PORT_TIMES, at::CLOCKS_END - at::PORT_TIMES) {
            self.clock_written(written);
        }
    }

    fn managers_written(&mut self) {
        for (manager, first) in self.managers.iter_mut().zip((at::MANAGERS..).step_by(8)) {
            manager.configure(self.memory.array(first));
        }
        for (second, manager) in self.managers.iter().enumerate() {
            let extent = manager.extent();
            for (first, other) in self.managers.iter().enumerate().take(second) {
                let other = other.extent();
                if extent.start < other.end && other.start < extent.end {
                    self.events.push(Event::Overlap { managers: (first, second) });
                }
            }
        }
    }

    fn clock_written(&mut self, written: &Range<u32>) {
        if overlaps(written, at::PORT_TIMES, 4) {
            self.clock.latch(self.now, &mut self.memory);
        }
        if overlaps(written, at::SYSTEM_TIME, 4) {
            let reference = u32::from_le_bytes(self.memory.array(at::SYSTEM_TIME));
            self.clock.compare(self.now, reference, &self.memory);
        }
        if overlaps(written, at::SPEED_START, 2) {
            self.clock.restart();
        }
        let activation = self.memory.byte(at::SYNC_ACTIVATION);
        if overlaps(written, at::SYNC_START, 8) && activation & clock::BY_START_TIME != 0 {
            self.memory.put(at::SYNC_ACTIVATION, &[activation | clock::ACTIVE]);
            self.clock.activate(self.now, &self.memory);
        }
        if overlaps(written, at::SYNC_ACTIVATION, 1) {
            self.clock.activate(self.now, &self.memory);
        }
    }
}

fn overlaps(range: &Range<u32>, first: u16, length: u16) -> bool {
    range.start < u32::from(first) + u32::from(length) && u32::from(first) < range.end
}
