//! Datagrams, one behind the other.

use std::mem;

use super::Command;

/// A datagram in its place in the frame: what a subdevice changes goes on.
#[derive(Debug)]
pub(crate) struct Datagram<'f> {
    /// None for `NOP` and for what is no command.
    pub(crate) command: Option<Command>,
    pub(crate) address: &'f mut [u8; 4],
    pub(crate) interrupt: &'f mut [u8; 2],
    pub(crate) data: &'f mut [u8],
    counter: &'f mut [u8; 2],
}

impl Datagram<'_> {
    /// The first two bytes of the address: a position or a station.
    pub(crate) const fn subdevice(&self) -> u16 {
        let [low, high, _, _] = *self.address;
        u16::from_le_bytes([low, high])
    }

    /// Counts the position up, as each subdevice does on the way.
    pub(crate) const fn count_position(&mut self) {
        let [low, high] = self.subdevice().wrapping_add(1).to_le_bytes();
        let [_, _, c, d] = *self.address;
        *self.address = [low, high, c, d];
    }

    /// The last two bytes of the address: a place in the memory of a subdevice.
    pub(crate) const fn offset(&self) -> u16 {
        let [_, _, low, high] = *self.address;
        u16::from_le_bytes([low, high])
    }

    /// All of the address.
    pub(crate) const fn logical(&self) -> u32 {
        u32::from_le_bytes(*self.address)
    }

    pub(crate) const fn working_counter(&self) -> u16 {
        u16::from_le_bytes(*self.counter)
    }

    pub(crate) const fn count(&mut self, by: u16) {
        *self.counter = self.working_counter().wrapping_add(by).to_le_bytes();
    }
}

/// The datagrams of a frame. It ends where one says that it is the last, or does not fit what is left.
#[derive(Debug)]
pub(crate) struct Datagrams<'f> {
    rest: &'f mut [u8],
}

impl<'f> Datagrams<'f> {
    pub(super) const fn new(rest: &'f mut [u8]) -> Self {
        Self { rest }
    }
}

impl<'f> Iterator for Datagrams<'f> {
    type Item = Datagram<'f>;

    fn next(&mut self) -> Option<Datagram<'f>> {
        let (command, rest) = mem::take(&mut self.rest).split_first_chunk_mut::<2>()?;
        let (address, rest) = rest.split_first_chunk_mut::<4>()?;
        let (length, rest) = rest.split_first_chunk_mut::<2>()?;
        let (interrupt, rest) = rest.split_first_chunk_mut::<2>()?;
        // 11 bits of length, three reserved, one of frames that circulate, and whether there is more
        let length = u16::from_le_bytes(*length);
        let (data, rest) = rest.split_at_mut_checked(usize::from(length & 0x07FF))?;
        let (counter, rest) = rest.split_first_chunk_mut::<2>()?;
        if length & 0x8000 != 0 {
            self.rest = rest;
        }
        let [command, _index] = *command;
        Some(Datagram { command: Command::of(command), address, interrupt, data, counter })
    }
}
