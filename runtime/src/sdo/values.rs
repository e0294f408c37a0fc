//! Where the values of a dictionary are kept, and how they are read and written there.

use super::{AbortCode, Dictionary, PdoRules, Range};
use crate::bytes::copy;
use crate::object::Value;

/// The struct that has the values of a device's dictionary. Generated code implements it.
///
/// The tables are asked of the values, and are constants in generated code. So a program that reads descriptions while it
/// runs can serve a device with tables that it made itself.
pub trait Values {
    /// The table of all entries.
    fn table(&self) -> &'static Dictionary;

    /// The bounds of the values that have any, ascending by place.
    #[inline]
    fn ranges(&self) -> &'static [Range] {
        &[]
    }

    /// Whether objects may be transferred as a whole (ETG.1000.6, complete access).
    #[inline]
    fn has_complete_access(&self) -> bool {
        false
    }

    /// What a master may make process data of; where there is nothing, mapping and assignment are objects as others.
    #[inline]
    fn process_data(&self) -> Option<&'static PdoRules> {
        None
    }

    /// The value at a place that the table names; nothing elsewhere.
    fn slot(&mut self, place: Place) -> Option<Slot<'_>>;
}

/// Where a value is kept: in which field, and there at which position.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The number of the field, of those of the device and then of an axis.
    pub field: u16,
    /// The position among the values of the field; 0 for a single value.
    pub item: u8,
    /// The axis that has the field, from 0; 0 for a field of the device.
    pub axis: u8,
}

/// A value in its place.
#[derive(Debug, PartialEq)]
pub enum Slot<'a> {
    /// One bit, in an SDO one byte.
    Bool(&'a mut bool),
    /// Signed, 1 byte.
    I8(&'a mut i8),
    /// Signed, 2 bytes.
    I16(&'a mut i16),
    /// Signed, 4 bytes.
    I32(&'a mut i32),
    /// Signed, 8 bytes.
    I64(&'a mut i64),
    /// Unsigned, 1 byte.
    U8(&'a mut u8),
    /// Unsigned, 2 bytes.
    U16(&'a mut u16),
    /// Unsigned, 4 bytes.
    U32(&'a mut u32),
    /// Unsigned, 8 bytes.
    U64(&'a mut u64),
    /// Floating point, 4 bytes.
    F32(&'a mut f32),
    /// Floating point, 8 bytes.
    F64(&'a mut f64),
    /// Text that can be written, or a number of a width that Rust has no type for.
    Bytes(&'a mut [u8]),
    /// Text that cannot be written, kept elsewhere.
    Text(&'static str),
}

/// Space for the bytes of any number.
pub(super) type Scratch = [u8; 8];

impl<'a> Slot<'a> {
    /// The value as an SDO carries it: where it is kept, or in `scratch`.
    #[inline]
    pub(super) fn bytes<'s>(self, scratch: &'s mut Scratch) -> &'s [u8]
    where
        'a: 's,
    {
        match self {
            Self::Bool(value) => number(*value, scratch),
            Self::I8(value) => number(*value, scratch),
            Self::I16(value) => number(*value, scratch),
            Self::I32(value) => number(*value, scratch),
            Self::I64(value) => number(*value, scratch),
            Self::U8(value) => number(*value, scratch),
            Self::U16(value) => number(*value, scratch),
            Self::U32(value) => number(*value, scratch),
            Self::U64(value) => number(*value, scratch),
            Self::F32(value) => number(*value, scratch),
            Self::F64(value) => number(*value, scratch),
            Self::Bytes(value) => value,
            Self::Text(value) => value.as_bytes(),
        }
    }

    /// Takes what an SDO carries. Text is filled up with zeros.
    #[inline]
    pub(super) fn store(self, data: &[u8]) -> Result<(), AbortCode> {
        match self {
            Self::Bool(value) => *value = Value::from_slice(data)?,
            Self::I8(value) => *value = Value::from_slice(data)?,
            Self::I16(value) => *value = Value::from_slice(data)?,
            Self::I32(value) => *value = Value::from_slice(data)?,
            Self::I64(value) => *value = Value::from_slice(data)?,
            Self::U8(value) => *value = Value::from_slice(data)?,
            Self::U16(value) => *value = Value::from_slice(data)?,
            Self::U32(value) => *value = Value::from_slice(data)?,
            Self::U64(value) => *value = Value::from_slice(data)?,
            Self::F32(value) => *value = Value::from_slice(data)?,
            Self::F64(value) => *value = Value::from_slice(data)?,
            Self::Bytes(value) => {
                let end = copy(value, data);
                value.get_mut(end..).unwrap_or_default().fill(0);
            }
            Self::Text(_) => return Err(AbortCode::READ_ONLY),
        }
        Ok(())
    }
}

/// No number is longer than the scratch: the compiler leaves the other way out.
#[inline]
fn number<T: Value>(value: T, scratch: &mut Scratch) -> &[u8] {
    let bytes = value.to_bytes();
    copy(scratch, bytes.as_ref());
    scratch.get(..T::SIZE).unwrap_or_default()
}
