//! The registers, and behind them the memory of mailboxes and process data.

use super::Written;
use super::registers::{RAM, is_writable};

/// One range of bytes from address 0 on.
#[derive(Debug, Clone)]
pub(crate) struct Memory {
    bytes: Vec<u8>,
}

impl Memory {
    /// Registers, and so many KiB behind them.
    pub(super) fn new(ram_kib: u8) -> Self {
        Self { bytes: vec![0; usize::from(RAM) + usize::from(ram_kib) * 1024] }
    }

    /// So many bytes; none if there are not so many.
    pub(crate) fn get(&self, address: u16, length: usize) -> Option<&[u8]> {
        self.bytes.get(usize::from(address)..)?.get(..length)
    }

    /// So many bytes of the RAM, for the device.
    pub(crate) fn get_mut(&mut self, address: u16, length: usize) -> Option<&mut [u8]> {
        self.bytes.get_mut(usize::from(address)..)?.get_mut(..length)
    }

    /// Bytes as an array; zeros where there are none.
    pub(crate) fn array<const N: usize>(&self, address: u16) -> [u8; N] {
        self.get(address, N).and_then(|bytes| bytes.first_chunk()).copied().unwrap_or([0; N])
    }

    pub(crate) fn byte(&self, address: u16) -> u8 {
        let [byte] = self.array(address);
        byte
    }

    pub(crate) fn word(&self, address: u16) -> u16 {
        u16::from_le_bytes(self.array(address))
    }

    /// Writes what only the device may.
    pub(crate) fn put(&mut self, address: u16, bytes: &[u8]) {
        if let Some(place) = self.get_mut(address, bytes.len()) {
            place.copy_from_slice(bytes);
        }
    }

    /// Reads for a master what there is; tells whether there was anything.
    pub(super) fn read(&self, address: u16, data: &mut [u8]) -> bool {
        let from = self.bytes.get(usize::from(address)..).unwrap_or_default();
        data.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
        !from.is_empty() && !data.is_empty()
    }

    /// Writes for a master what it may write and what is not locked; tells whether there was anything.
    pub(super) fn write(&mut self, address: u16, data: Written<'_>, is_locked: impl Fn(u16) -> bool) -> bool {
        if address >= RAM {
            let Some(place) = self.bytes.get_mut(usize::from(address)..) else { return false };
            data.store(place);
            return !place.is_empty() && data.len() > 0;
        }
        let mut is_any = false;
        for (offset, at) in (0..data.len()).zip(address..) {
            let is_open = at >= RAM || is_writable(at) && !is_locked(at);
            if let Some(place) = self.get_mut(at, 1).filter(|_| is_open) {
                data.part(offset, 1).store(place);
                is_any = true;
            }
        }
        is_any
    }
}
