//! Sync managers: whoever exchanges data through memory does not get in the other's way.

mod exchange;

use std::ops::Range;

use devc_runtime::esm::Configured;

use super::{Memory, Written};
use exchange::Exchange;

/// A sync manager (ETG.1000.4, sync manager). It is accessed from its first byte on, and an access ends with the last byte.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SyncManager {
    settings: Configured,
    exchange: Exchange,
    /// The buffer that the master has begun to access.
    opened: Option<u8>,
    /// Whether it was written, or read, since the other side began.
    is_written: bool,
    is_read: bool,
    /// The repeat bit as the master left it, and as the device answered.
    repeat: (bool, bool),
}

/// What became of an access of a master.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Accessed {
    /// It is not the master's turn, not its direction, or not the first byte first.
    Denied,
    /// There is more to come.
    Part,
    /// The last byte was among it.
    Done,
}

impl SyncManager {
    pub(super) fn new() -> Self {
        Self {
            settings: Configured::default(),
            exchange: Exchange::mailbox(),
            opened: None,
            is_written: false,
            is_read: false,
            repeat: (false, false),
        }
    }

    /// Takes what a master wrote into the registers. One that is switched on begins anew.
    pub(super) fn configure(&mut self, registers: [u8; 8]) {
        let settings = Configured::from_registers(registers);
        let [.., activate, _] = registers;
        let asked = activate & 0x02 != 0;
        if settings != self.settings {
            let is_mailbox = settings.control & 0x03 == 0x02;
            let exchange = if is_mailbox { Exchange::mailbox() } else { Exchange::buffered() };
            *self = Self { settings, exchange, repeat: (asked, asked), ..Self::new() };
        }
        self.repeat.0 = asked;
    }

    pub(crate) const fn settings(&self) -> Configured {
        self.settings
    }

    /// Whether it is the master who writes.
    pub(crate) const fn is_output(&self) -> bool {
        self.settings.control & 0x0C == 0x04
    }

    /// Whether complete data of the master starts the watchdog anew.
    pub(super) const fn feeds_watchdog(&self) -> bool {
        self.is_output() && self.settings.control & 0x40 != 0
    }

    pub(super) const fn is_mailbox(&self) -> bool {
        matches!(self.exchange, Exchange::Mailbox { .. })
    }

    /// What it takes of the memory; nothing if it is off.
    pub(super) const fn extent(&self) -> Range<u32> {
        let start = self.settings.address as u32;
        let is_any = self.settings.is_on && start >= super::registers::RAM as u32;
        let length = if is_any { self.settings.length as u32 * self.exchange.buffers() } else { 0 };
        start..start + length
    }

    /// The registers status and PDI control, as they are now.
    pub(super) const fn status(&self) -> [u8; 3] {
        let flags = self.is_written as u8 | (self.is_read as u8) << 1;
        let activate = self.settings.is_on as u8 | (self.repeat.0 as u8) << 1;
        [self.exchange.status() | flags, activate, (self.repeat.1 as u8) << 1]
    }

    /// Whether the device did something that a master waits for.
    pub(super) const fn is_pending(&self) -> bool {
        if self.is_output() { self.is_read } else { self.is_written }
    }

    /// A master reads, from a byte of the area on.
    pub(super) fn read(&mut self, memory: &Memory, offset: u32, data: &mut [u8]) -> Accessed {
        if self.is_output() {
            return Accessed::Denied;
        }
        if offset == 0 {
            self.opened = self.exchange.begin_read();
            self.is_written &= self.opened.is_none();
        }
        let Some(from) = self.place(offset, data.len()) else { return Accessed::Denied };
        memory.read(from, data);
        if !self.is_last(offset, data.len()) {
            return Accessed::Part;
        }
        self.exchange.end_read();
        (self.opened, self.is_read) = (None, true);
        Accessed::Done
    }

    /// A master writes, from a byte of the area on.
    pub(super) fn write(&mut self, memory: &mut Memory, offset: u32, data: Written<'_>) -> Accessed {
        if !self.is_output() {
            return Accessed::Denied;
        }
        if offset == 0 {
            self.opened = self.exchange.begin_write();
            self.is_read &= self.opened.is_none();
        }
        let Some(to) = self.place(offset, data.len()) else { return Accessed::Denied };
        memory.write(to, data, |_| false);
        if !self.is_last(offset, data.len()) {
            return Accessed::Part;
        }
        self.exchange.end_write();
        (self.opened, self.is_written) = (None, true);
        Accessed::Done
    }

    /// The device takes what the master wrote, if there is something new.
    pub(crate) fn take<'m>(&mut self, memory: &'m Memory) -> Option<&'m [u8]> {
        if !self.settings.is_on || !self.is_output() || !self.is_written {
            return None;
        }
        let buffer = self.exchange.begin_read()?;
        self.exchange.end_read();
        (self.is_written, self.is_read) = (false, true);
        memory.get(self.buffer(buffer)?, self.settings.length.into())
    }

    /// The device gives what the master is to read: the rest of the area is zero. Not while a message waits.
    pub(crate) fn give(&mut self, memory: &mut Memory, data: &[u8]) -> bool {
        let length = usize::from(self.settings.length);
        if !self.settings.is_on || self.is_output() {
            return false;
        }
        let buffer = self.exchange.begin_write().and_then(|buffer| self.buffer(buffer));
        let Some(place) = buffer.and_then(|place| memory.get_mut(place, length)) else { return false };
        place.fill(0);
        Written::all(data).store(place);
        self.exchange.end_write();
        (self.is_written, self.is_read) = (true, false);
        true
    }

    /// Whether the device may give a message.
    pub(crate) const fn is_free(&self) -> bool {
        self.settings.is_on && !self.is_output() && self.exchange.begin_write().is_some()
    }

    /// Whether the master asks for the last message once more, as it did not see it; the device answers that it does so.
    pub(crate) const fn take_repeat(&mut self) -> bool {
        let is_asked = self.repeat.0 != self.repeat.1;
        self.repeat.1 = self.repeat.0;
        is_asked
    }

    /// Where a part of the opened buffer lies; none if there is none, or if it reaches behind the buffer.
    fn place(&self, offset: u32, length: usize) -> Option<u16> {
        let end = usize::try_from(offset).ok()?.checked_add(length)?;
        if end > usize::from(self.settings.length) {
            return None;
        }
        self.buffer(self.opened?)?.checked_add(u16::try_from(offset).ok()?)
    }

    fn buffer(&self, number: u8) -> Option<u16> {
        self.settings.address.checked_add(self.settings.length.checked_mul(number.into())?)
    }

    fn is_last(&self, offset: u32, length: usize) -> bool {
        offset as usize + length == usize::from(self.settings.length)
    }
}
