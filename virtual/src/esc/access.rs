//! What a datagram does in a controller.

use super::manager::Accessed;
use super::registers as at;
use super::{Controller, SyncManager, Written};
use crate::event::Event;
use crate::frame::{Command, Datagram, Target};

/// A part of an access that lies in one sync manager or in none.
struct Part {
    address: u16,
    /// The number of the manager, and the byte of its area.
    manager: Option<(usize, u32)>,
    length: usize,
}

impl Controller {
    /// Lets a datagram pass; tells whether it was for this controller.
    pub(crate) fn pass(&mut self, datagram: &mut Datagram<'_>) -> bool {
        let Some(command) = datagram.command else { return true };
        let is_addressed = match command.target {
            Target::Position => {
                let is_here = datagram.subdevice() == 0;
                datagram.count_position();
                is_here
            }
            Target::Station => self.has_station(datagram.subdevice()),
            Target::Broadcast => {
                datagram.count_position();
                true
            }
            Target::Logical => true,
        };
        let (reads, writes) = match command {
            Command { is_multiple: true, .. } => (is_addressed, !is_addressed),
            Command { reads, writes, .. } => (reads && is_addressed, writes && is_addressed),
        };
        let (is_read, is_written) = match command.target {
            Target::Logical => self.logical(datagram.logical(), datagram.data, reads, writes),
            target => {
                let is_added = target == Target::Broadcast;
                self.physical(datagram.offset(), datagram.data, (reads, writes), is_added)
            }
        };
        let of_write = if reads { 2 } else { 1 };
        datagram.count(u16::from(is_read) + if is_written { of_write } else { 0 });
        self.interrupt(datagram.interrupt);
        is_addressed && (command.target != Target::Logical || is_read || is_written)
    }

    /// Whether a station address is its own: that which a master gave it, or the alias, if the master switched that on.
    fn has_station(&self, station: u16) -> bool {
        let uses_alias = self.memory.byte(at::DL_CONTROL + 3) & 0x01 != 0;
        station == self.memory.word(at::STATION) || uses_alias && station == self.memory.word(at::ALIAS)
    }

    /// Adds the events that the master wants to hear of.
    fn interrupt(&self, interrupt: &mut [u8; 2]) {
        let mask = self.memory.word(at::EVENT_MASK);
        if mask != 0 {
            let request = u16::from_le_bytes(*interrupt) | self.event_request() & mask;
            *interrupt = request.to_le_bytes();
        }
    }

    /// At an address of its own. What is read by a broadcast is added to what others have read.
    fn physical(
        &mut self,
        address: u16,
        data: &mut [u8],
        (reads, writes): (bool, bool),
        is_added: bool,
    ) -> (bool, bool) {
        if !reads {
            return (false, writes && self.write(address, Written::all(data)));
        }
        let came = if writes || is_added { data.to_vec() } else { Vec::new() };
        let is_read = self.read(address, data);
        if is_added {
            data.iter_mut().zip(&came).for_each(|(to, from)| *to |= *from);
        }
        (is_read, writes && self.write(address, Written::all(&came)))
    }

    /// Where FMMUs map it. What comes is written before what is read takes its place.
    fn logical(&mut self, address: u32, data: &mut [u8], reads: bool, writes: bool) -> (bool, bool) {
        let (mut is_read, mut is_written) = (false, false);
        let fmmus = self.fmmus;
        for fmmu in fmmus.iter().filter(|fmmu| writes && fmmu.writes) {
            let Some(overlap) = fmmu.overlap(address, data.len()) else { continue };
            if let Some((first, _)) = overlap.memory() {
                is_written |= overlap.written(data, |written| self.write(first, written));
            }
        }
        for fmmu in fmmus.iter().filter(|fmmu| reads && fmmu.reads) {
            let Some(overlap) = fmmu.overlap(address, data.len()) else { continue };
            let Some((first, length)) = overlap.memory() else { continue };
            is_read |= match overlap.bytes() {
                Some(bytes) => self.read(first, data.get_mut(bytes).unwrap_or_default()),
                None => {
                    let mut memory = vec![0; length];
                    let is_read = self.read(first, &mut memory);
                    if is_read {
                        overlap.gather(&memory, data);
                    }
                    is_read
                }
            };
        }
        (is_read, is_written)
    }

    /// Reads for a master; tells whether there was anything to be read.
    pub(super) fn read(&mut self, address: u16, data: &mut [u8]) -> bool {
        let range = u32::from(address)..u32::from(address) + data.len() as u32;
        if address < at::RAM {
            self.show(&range);
        }
        let (mut is_any, mut done) = (false, 0);
        while let Some(Part { address, manager, length }) = self.part(address, done, data.len()) {
            let Some(part) = data.get_mut(done..done + length) else { break };
            is_any |=
                match manager.and_then(|(number, offset)| Some((self.managers.get_mut(number)?, offset))) {
                    None => self.memory.read(address, part),
                    Some((manager, offset)) => manager.read(&self.memory, offset, part) != Accessed::Denied,
                };
            done += length;
        }
        if address < at::RAM {
            self.registers_read(&range);
        }
        is_any
    }

    /// Writes for a master; tells whether anything was to be written.
    pub(super) fn write(&mut self, address: u16, data: Written<'_>) -> bool {
        let (mut is_any, mut done) = (false, 0);
        while let Some(Part { address, manager, length }) = self.part(address, done, data.len()) {
            let part = data.part(done, length);
            is_any |= match manager {
                None => self.write_memory(address, part),
                Some((number, offset)) => self.write_manager(number, offset, part),
            };
            done += length;
        }
        is_any
    }

    fn write_memory(&mut self, address: u16, data: Written<'_>) -> bool {
        if address >= at::RAM {
            return self.memory.write(address, data, |_| false);
        }
        let is_eeprom_locked = self.eeprom.is_locked(&self.memory);
        let managers = &self.managers;
        let is_any =
            self.memory.write(address, data, |register| is_locked(managers, is_eeprom_locked, register));
        if is_any {
            self.registers_written(&(u32::from(address)..u32::from(address) + data.len() as u32));
        } else if data.len() > 0 {
            self.events.push(Event::NotWritable { address });
        }
        is_any
    }

    fn write_manager(&mut self, number: usize, offset: u32, data: Written<'_>) -> bool {
        let Some(manager) = self.managers.get_mut(number) else { return false };
        let accessed = manager.write(&mut self.memory, offset, data);
        if accessed == Accessed::Done && !manager.is_mailbox() {
            self.outputs_at = Some(self.now);
            if manager.feeds_watchdog() {
                self.watchdog.feed();
            }
        }
        accessed != Accessed::Denied
    }

    /// The next part of an access; none if all is done.
    fn part(&self, address: u16, done: usize, length: usize) -> Option<Part> {
        let here = u32::from(address) + u32::try_from(done).ok()?;
        let end = u32::from(address) + u32::try_from(length).ok()?;
        let first = u16::try_from(here).ok().filter(|_| here < end)?;
        let mut until = end;
        for (number, manager) in self.managers.iter().enumerate() {
            let extent = manager.extent();
            if extent.contains(&here) {
                let length = (end.min(extent.end) - here) as usize;
                return Some(Part { address: first, manager: Some((number, here - extent.start)), length });
            }
            if extent.start > here && !extent.is_empty() {
                until = until.min(extent.start);
            }
        }
        Some(Part { address: first, manager: None, length: (until - here) as usize })
    }
}

/// Whether a register cannot be written now: settings of a sync manager that is on, and the EEPROM's while it is used.
fn is_locked(managers: &[SyncManager], is_eeprom_locked: bool, register: u16) -> bool {
    let in_managers = register.wrapping_sub(at::MANAGERS);
    if in_managers < at::MANAGER_SIZE * at::COUNT {
        let manager = managers.get(usize::from(in_managers / at::MANAGER_SIZE));
        return in_managers % at::MANAGER_SIZE < 5 && manager.is_some_and(|manager| manager.settings().is_on);
    }
    is_eeprom_locked && (at::EEPROM_CONTROL..at::EEPROM_CONTROL + 14).contains(&register)
}
