//! From logical addresses to places in memory, to the bit.

use super::Written;

/// A unit of the fieldbus memory management (ETG.1000.4, FMMU).
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Fmmu {
    /// The first bit, counted from that of logical address 0 on, and the number of bits.
    first: u64,
    bits: u64,
    /// The first bit in memory.
    physical: u64,
    pub(super) reads: bool,
    pub(super) writes: bool,
}

/// What an FMMU and a datagram have in common, in bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Overlap {
    /// Where it begins in the data of the datagram.
    data: usize,
    /// Where it begins in memory.
    memory: usize,
    bits: usize,
}

impl Fmmu {
    /// The FMMU that the registers set; one that maps nothing if it is not active.
    pub(super) fn from_registers(registers: [u8; 16]) -> Self {
        let [a, b, c, d, e, f, first, last, g, h, bit, kind, active, ..] = registers;
        let logical = u64::from(u32::from_le_bytes([a, b, c, d]));
        let length = u64::from(u16::from_le_bytes([e, f]));
        if active & 0x01 == 0 || length == 0 {
            return Self::default();
        }
        let first = logical * 8 + u64::from(first & 0x07);
        let end = (logical + length - 1) * 8 + u64::from(last & 0x07) + 1;
        Self {
            first,
            bits: end.saturating_sub(first),
            physical: u64::from(u16::from_le_bytes([g, h])) * 8 + u64::from(bit & 0x07),
            reads: kind & 0x01 != 0,
            writes: kind & 0x02 != 0,
        }
    }

    /// The part of it that lies in so many bytes from a logical address on.
    pub(super) fn overlap(self, address: u32, length: usize) -> Option<Overlap> {
        let start = u64::from(address) * 8;
        let end = start + length as u64 * 8;
        let first = self.first.max(start);
        let last = (self.first + self.bits).min(end);
        let bits = last.checked_sub(first).filter(|bits| *bits > 0)?;
        Some(Overlap {
            data: usize::try_from(first - start).ok()?,
            memory: usize::try_from(self.physical + (first - self.first)).ok()?,
            bits: usize::try_from(bits).ok()?,
        })
    }
}

impl Overlap {
    /// The first byte in memory, and how many bytes it touches; none behind the last address.
    pub(super) fn memory(self) -> Option<(u16, usize)> {
        let first = self.memory / 8;
        Some((u16::try_from(first).ok()?, (self.memory + self.bits).div_ceil(8) - first))
    }

    /// Where it lies in the data, if it is whole bytes on both sides.
    pub(super) fn bytes(self) -> Option<std::ops::Range<usize>> {
        let is_whole = (self.data | self.memory | self.bits).is_multiple_of(8);
        is_whole.then(|| self.data / 8..(self.data + self.bits) / 8)
    }

    /// Puts what was read from memory into the data.
    pub(super) fn gather(self, memory: &[u8], data: &mut [u8]) {
        let offset = self.memory % 8;
        for bit in 0..self.bits {
            put(data, self.data + bit, get(memory, offset + bit));
        }
    }

    /// What of the data goes to memory, with its mask.
    pub(super) fn scatter(self, data: &[u8]) -> (Vec<u8>, Vec<u8>) {
        let offset = self.memory % 8;
        let length = (offset + self.bits).div_ceil(8);
        let (mut memory, mut mask) = (vec![0; length], vec![0; length]);
        for bit in 0..self.bits {
            put(&mut memory, offset + bit, get(data, self.data + bit));
            put(&mut mask, offset + bit, true);
        }
        (memory, mask)
    }

    /// Runs with what is to be written.
    pub(super) fn written<R>(self, data: &[u8], write: impl FnOnce(Written<'_>) -> R) -> R {
        match self.bytes() {
            Some(bytes) => write(Written::all(data.get(bytes).unwrap_or_default())),
            None => {
                let (memory, mask) = self.scatter(data);
                write(Written::masked(&memory, &mask))
            }
        }
    }
}

fn get(bytes: &[u8], bit: usize) -> bool {
    bytes.get(bit / 8).is_some_and(|byte| byte >> (bit % 8) & 1 != 0)
}

fn put(bytes: &mut [u8], bit: usize, value: bool) {
    if let Some(byte) = bytes.get_mut(bit / 8) {
        *byte = *byte & !(1 << (bit % 8)) | u8::from(value) << (bit % 8);
    }
}
