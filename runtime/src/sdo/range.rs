//! Bounds of values.

use core::cmp::Ordering;

use super::{AbortCode, Place};

/// The bounds of the value at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The place; with [`Range::EVERY_AXIS`] the places on all axes.
    pub place: Place,
    /// The least and the greatest value that may be written.
    pub limits: Limits,
}

/// The least and the greatest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limits {
    /// Of a number with a sign.
    Signed(i64, i64),
    /// Of a number without a sign.
    Unsigned(u64, u64),
    /// Of a number with a fraction.
    Real(f64, f64),
}

impl Range {
    /// Stands for all axes in a place.
    pub const EVERY_AXIS: u8 = u8::MAX;

    /// The bounds of a place, in ranges that ascend by place.
    pub fn of(ranges: &'static [Self], place: Place) -> Option<Limits> {
        let key = |place: Place| (place.field, place.item);
        let from = ranges.partition_point(|range| key(range.place) < key(place));
        let same = ranges.get(from..)?.iter().take_while(|range| key(range.place) == key(place));
        let mut here = same.filter(|range| [place.axis, Self::EVERY_AXIS].contains(&range.place.axis));
        here.next().map(|range| range.limits)
    }
}

impl Limits {
    /// Whether the bounds allow a value as an SDO carries it, and if not, the abort code that says why.
    ///
    /// ```
    /// use devc_runtime::sdo::{AbortCode, Limits};
    ///
    /// let limits = Limits::Signed(-10, 100);
    /// assert_eq!(limits.check(&[0xF6, 0xFF]), Ok(()));
    /// assert_eq!(limits.check(&[0xF5, 0xFF]), Err(AbortCode::VALUE_TOO_LOW));
    /// assert_eq!(limits.check(&[101, 0]), Err(AbortCode::VALUE_TOO_HIGH));
    /// ```
    pub fn check(self, data: &[u8]) -> Result<(), AbortCode> {
        match self {
            Self::Signed(min, max) => within(Some(signed(data)), min, max),
            Self::Unsigned(min, max) => within(Some(unsigned(data)), min, max),
            Self::Real(min, max) => within(real(data), min, max),
        }
    }
}

impl Limits {
    /// The least and the greatest value in eight bytes each, of which an entry of so many has the first; those of
    /// four bytes with a fraction are in single precision.
    pub(crate) fn bytes(self, length: usize) -> [[u8; 8]; 2] {
        match self {
            Self::Signed(min, max) => [min.to_le_bytes(), max.to_le_bytes()],
            Self::Unsigned(min, max) => [min.to_le_bytes(), max.to_le_bytes()],
            Self::Real(min, max) if length == 4 => {
                [min, max].map(|bound| u64::from((bound as f32).to_bits()).to_le_bytes())
            }
            Self::Real(min, max) => [min.to_le_bytes(), max.to_le_bytes()],
        }
    }
}

fn within<T: PartialOrd>(value: Option<T>, min: T, max: T) -> Result<(), AbortCode> {
    let value = value.ok_or(AbortCode::LENGTH_MISMATCH)?;
    match (value.partial_cmp(&min), value.partial_cmp(&max)) {
        (Some(Ordering::Less), _) => Err(AbortCode::VALUE_TOO_LOW),
        (_, Some(Ordering::Greater)) => Err(AbortCode::VALUE_TOO_HIGH),
        (Some(_), Some(_)) => Ok(()),
        // no number
        _ => Err(AbortCode::VALUE_OUT_OF_RANGE),
    }
}

fn unsigned(data: &[u8]) -> u64 {
    data.iter().rev().fold(0, |high, byte| high << 8 | u64::from(*byte))
}

/// Of fewer than eight bytes, the highest bit is the sign.
fn signed(data: &[u8]) -> i64 {
    let is_negative = data.last().is_some_and(|byte| byte & 0x80 != 0);
    data.iter().rev().fold(if is_negative { -1 } else { 0 }, |high, byte| high << 8 | i64::from(*byte))
}

fn real(data: &[u8]) -> Option<f64> {
    match data {
        [a, b, c, d] => Some(f32::from_le_bytes([*a, *b, *c, *d]).into()),
        _ => data.try_into().ok().map(f64::from_le_bytes),
    }
}
