//! How the entries of an object lie one behind the other when it is transferred as a whole.
//!
//! It is the layout of the object's type in the ESI file (ETG.2000, data types), which a master goes by: subindex 0 takes
//! 16 bits, entries of less than a byte are side by side, and all others begin at a byte (ETG.1000.6, complete access;
//! ETG.1020, entries in a complete access).

use super::values::Scratch;
use super::{EntryInfo, Part};

/// Bits that an entry takes.
fn width(entry: &EntryInfo) -> usize {
    if entry.subindex == 0 { 16 } else { entry.bits.into() }
}

/// Whether an entry lies beside the one before it, and not at a byte of its own.
fn is_part_of_byte(entry: &EntryInfo) -> bool {
    width(entry) < 8
}

/// Entries, each with its first bit in the data of the transfer.
#[derive(Debug, Clone)]
pub(super) struct Places<I> {
    entries: I,
    free: usize,
}

impl<I: Iterator<Item = &'static EntryInfo>> Places<I> {
    /// The entries of a transfer, in their order.
    pub(super) const fn new(entries: I) -> Self {
        Self { entries, free: 0 }
    }

    /// The length of the transfer in bytes.
    pub(super) fn bytes(mut self) -> usize {
        self.by_ref().for_each(drop);
        self.free.div_ceil(8)
    }
}

impl<I: Iterator<Item = &'static EntryInfo>> Iterator for Places<I> {
    type Item = (&'static EntryInfo, usize);

    fn next(&mut self) -> Option<Self::Item> {
        let entry = self.entries.next()?;
        let place = if is_part_of_byte(entry) { self.free } else { self.free.next_multiple_of(8) };
        self.free = place.saturating_add(width(entry));
        Some((entry, place))
    }
}

/// The data of an entry that begins at this bit: a part of the whole, or what is put together in `scratch`. The number of
/// entries is one byte, whatever its type is.
pub(super) fn piece<'d>(
    data: &'d [u8],
    entry: &EntryInfo,
    place: usize,
    scratch: &'d mut Scratch,
) -> &'d [u8] {
    let from = data.get(place / 8..).unwrap_or_default();
    let length = usize::from(entry.bytes());
    if entry.subindex > 0 && !is_part_of_byte(entry) {
        return from.get(..length).unwrap_or(from);
    }
    let byte = |at| u16::from(from.get(at).copied().unwrap_or(0));
    let width = width(entry).min(8);
    let bits = (byte(0) | byte(1) << 8) >> (place % 8) & !(u16::MAX << width);
    let [low, _] = bits.to_le_bytes();
    *scratch = [low, 0, 0, 0, 0, 0, 0, 0];
    scratch.get(..length).unwrap_or_default()
}

/// A transfer that is being put together.
#[derive(Debug)]
pub(super) struct Bits<'p, 'b> {
    part: &'p mut Part<'b>,
    /// What has not filled a byte yet, and how many bits it is.
    begun: u16,
    count: usize,
}

impl<'p, 'b> Bits<'p, 'b> {
    pub(super) const fn new(part: &'p mut Part<'b>) -> Self {
        Self { part, begun: 0, count: 0 }
    }

    /// Appends the value of an entry; what of it is missing is zero.
    pub(super) fn put(&mut self, entry: &EntryInfo, value: &[u8]) {
        if is_part_of_byte(entry) {
            let value = u16::from(value.first().copied().unwrap_or(0)) & !(u16::MAX << width(entry));
            self.begun |= value << self.count;
            self.count = self.count.saturating_add(width(entry));
            if self.count >= 8 {
                self.put_byte();
            }
            return;
        }
        self.end();
        // the number of entries is one byte, whatever its type is
        let value = if entry.subindex == 0 { value.get(..1).unwrap_or_default() } else { value };
        self.part.put(value);
        for _ in value.len()..width(entry).div_ceil(8) {
            self.part.put(&[0]);
        }
    }

    /// Fills the last byte up.
    pub(super) fn end(&mut self) {
        if self.count > 0 {
            self.put_byte();
        }
    }

    fn put_byte(&mut self) {
        let [byte, rest] = self.begun.to_le_bytes();
        self.part.put(&[byte]);
        (self.begun, self.count) = (rest.into(), self.count.saturating_sub(8));
    }
}
