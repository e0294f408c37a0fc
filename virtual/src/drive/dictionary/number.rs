//! Whole numbers of a dictionary, as the axes read and write them.

use devc_runtime::object::Address;
use devc_runtime::sdo::{Dictionary, Place};

use super::Values;

/// An entry that is a whole number and can change, found once.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Number {
    place: Place,
    bits: u32,
    is_signed: bool,
}

impl Number {
    /// The number at an address; none if there is no such entry, or it never changes.
    pub(crate) fn find(table: &Dictionary, address: Address) -> Option<Self> {
        let found = table.find(address).ok()?;
        let bits = u32::from(found.entry.bits);
        let is_signed = found.entry.data_type.is_signed();
        (8..=64).contains(&bits).then_some(Self { place: found.place()?, bits, is_signed })
    }

    /// Its value; 0 if it is kept in another way.
    pub(crate) fn get(self, values: &Values) -> i64 {
        let bytes = values.bytes(self.place).unwrap_or_default();
        let is_negative = self.is_signed && bytes.last().is_some_and(|byte| byte & 0x80 != 0);
        bytes.iter().rev().fold(if is_negative { -1 } else { 0 }, |high, byte| high << 8 | i64::from(*byte))
    }

    /// Writes it, or the end of its range that is nearer.
    pub(crate) fn set(self, values: &mut Values, value: i64) {
        let (least, most) = self.range();
        let value = i128::from(value).clamp(least, most);
        if let Some(bytes) = values.bytes_mut(self.place) {
            for (byte, new) in bytes.iter_mut().zip(value.to_le_bytes()) {
                *byte = new;
            }
        }
    }

    /// The least and the greatest number of its type.
    pub(crate) fn range(self) -> (i128, i128) {
        match self.is_signed {
            true => (-(1 << self.bits.saturating_sub(1)), (1 << self.bits.saturating_sub(1)) - 1),
            false => (0, (1 << self.bits) - 1),
        }
    }
}
