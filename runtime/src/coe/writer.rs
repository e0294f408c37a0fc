//! Bytes that are written one after another.

use super::Malformed;
use crate::bytes::copy;

/// A message that is being written.
#[derive(Debug)]
pub(super) struct Writer<'a> {
    rest: &'a mut [u8],
    written: usize,
    is_full: bool,
}

impl<'a> Writer<'a> {
    pub(super) const fn new(buffer: &'a mut [u8]) -> Self {
        Self { rest: buffer, written: 0, is_full: false }
    }

    /// Appends bytes, if there is room for all of them.
    pub(super) fn put(mut self, bytes: &[u8]) -> Self {
        match core::mem::take(&mut self.rest).split_at_mut_checked(bytes.len()) {
            Some((room, rest)) => {
                self.written = self.written.saturating_add(copy(room, bytes));
                self.rest = rest;
            }
            None => self.is_full = true,
        }
        self
    }

    /// Appends zeros up to this many bytes in all.
    pub(super) fn pad_to(mut self, length: usize) -> Self {
        while self.written < length && !self.is_full {
            self = self.put(&[0]);
        }
        self
    }

    /// How many bytes were written.
    pub(super) fn end(self) -> Result<usize, Malformed> {
        if self.is_full { Err(Malformed::NoRoom) } else { Ok(self.written) }
    }
}
