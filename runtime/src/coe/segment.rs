//! Segments: what follows where a value does not fit one message (ETG.1000.6, SDO segments).

use super::Malformed;
use super::writer::Writer;

/// A segment takes at least this many bytes; those that are not used are counted in its command.
const LEAST: usize = 7;

/// A part of a value that follows its first part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Segment<'a> {
    pub(super) toggle: bool,
    pub(super) is_last: bool,
    pub(super) data: &'a [u8],
}

/// The toggle bit of a command.
pub(super) const fn toggle(command: u8) -> bool {
    command & 0x10 != 0
}

/// The bit of a command for this toggle.
pub(super) const fn toggle_bit(toggle: bool) -> u8 {
    if toggle { 0x10 } else { 0 }
}

impl<'a> Segment<'a> {
    /// The segment behind a command, whose specifier is not looked at.
    pub(super) fn decode(command: u8, data: &'a [u8]) -> Result<Self, Malformed> {
        let unused = if data.len() == LEAST { usize::from(command >> 1 & 0x07) } else { 0 };
        let length = data.len().checked_sub(unused).ok_or(Malformed::TooShort)?;
        let data = data.get(..length).ok_or(Malformed::TooShort)?;
        Ok(Self { toggle: toggle(command), is_last: command & 0x01 != 0, data })
    }

    /// Writes a command of specifier 0 and the data.
    pub(super) fn encode(self, body: &mut [u8]) -> Result<usize, Malformed> {
        let command = Self::command(self.toggle, self.is_last, self.data.len());
        Writer::new(body).put(&[command]).put(self.data).pad_to(LEAST.saturating_add(1)).end()
    }

    /// The command of specifier 0 for so many bytes of data.
    pub(super) fn command(toggle: bool, is_last: bool, length: usize) -> u8 {
        let unused = u8::try_from(LEAST.saturating_sub(length)).unwrap_or(0);
        toggle_bit(toggle) | unused << 1 | u8::from(is_last)
    }
}
