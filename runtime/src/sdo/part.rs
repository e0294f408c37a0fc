//! The part of a transfer that fits into a message.

use crate::bytes::copy;

/// Bytes that are put in one after another; of these it keeps as many as fit, from a position on.
#[derive(Debug)]
pub struct Part<'a> {
    buffer: &'a mut [u8],
    skip: usize,
    filled: usize,
    total: usize,
}

impl<'a> Part<'a> {
    /// A part that begins `skip` bytes into the transfer.
    pub const fn new(buffer: &'a mut [u8], skip: usize) -> Self {
        Self { buffer, skip, filled: 0, total: 0 }
    }

    /// Whether the transfer begins with it.
    pub const fn is_first(&self) -> bool {
        self.skip == 0
    }

    /// The bytes put in so far, whether kept or not.
    pub const fn total(&self) -> usize {
        self.total
    }

    /// How many bytes it keeps.
    pub const fn filled(&self) -> usize {
        self.filled
    }

    /// The bytes it keeps.
    pub fn bytes(self) -> &'a [u8] {
        let filled = self.filled;
        let buffer: &'a [u8] = self.buffer;
        buffer.get(..filled).unwrap_or_default()
    }

    /// Whether nothing comes behind it.
    pub const fn is_last(&self) -> bool {
        self.skip.saturating_add(self.filled) >= self.total
    }

    /// The bytes that come next in the transfer.
    pub(super) fn put(&mut self, bytes: &[u8]) {
        let before = self.skip.saturating_sub(self.total).min(bytes.len());
        self.total = self.total.saturating_add(bytes.len());
        let room = self.buffer.get_mut(self.filled..).unwrap_or_default();
        let copied = copy(room, bytes.get(before..).unwrap_or_default());
        self.filled = self.filled.saturating_add(copied);
    }
}
