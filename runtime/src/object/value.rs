//! Values as they are on the wire.

use crate::bytes::{ByteArray, WrongLength};
use crate::sdo::DataType;

/// A type of fixed size with its encoding: little-endian, integers in two's complement, floats as IEEE 754
/// (CiA 301, data types and encoding rules; ETG.1000.6, data types).
///
/// Generated words and codes implement it too, in terms of the integer that they wrap.
///
/// ```
/// use devc_runtime::object::Value;
///
/// assert_eq!((-2_i16).to_bytes(), [0xFE, 0xFF]);
/// assert_eq!(u32::from_slice(&[1, 0, 0, 0]), Ok(1));
/// assert_eq!(u32::from_slice(&[1, 0]).unwrap_err().to_string(), "expected 4 bytes, found 2");
/// ```
pub trait Value: Copy {
    /// The encoded value, an array of its size.
    type Bytes: ByteArray;

    /// Bytes that the value takes in an SDO.
    const SIZE: usize = <Self::Bytes as ByteArray>::LEN;

    /// Bits that the value takes in process data.
    const BITS: usize = 8 * Self::SIZE;

    /// The type's number in the dictionary.
    const DATA_TYPE: DataType;

    /// Encodes the value.
    fn to_bytes(self) -> Self::Bytes;

    /// Decodes a value.
    fn from_bytes(bytes: Self::Bytes) -> Self;

    /// Decodes a value from data that has to be just as long.
    #[inline]
    fn from_slice(bytes: &[u8]) -> Result<Self, WrongLength> {
        Self::Bytes::from_slice(bytes).map(|bytes| Self::from_bytes(*bytes))
    }
}

macro_rules! little_endian {
    ($($type:ty = $data_type:ident),+ $(,)?) => {$(
        impl Value for $type {
            type Bytes = [u8; size_of::<$type>()];
            const DATA_TYPE: DataType = DataType::$data_type;

            #[inline]
            fn to_bytes(self) -> Self::Bytes {
                self.to_le_bytes()
            }

            #[inline]
            fn from_bytes(bytes: Self::Bytes) -> Self {
                Self::from_le_bytes(bytes)
            }
        }
    )+};
}

little_endian! {
    u8 = UNSIGNED8, u16 = UNSIGNED16, u32 = UNSIGNED32, u64 = UNSIGNED64,
    i8 = INTEGER8, i16 = INTEGER16, i32 = INTEGER32, i64 = INTEGER64,
    f32 = REAL32, f64 = REAL64,
}

/// One byte in an SDO; every byte but 0 is read as true, 1 is written.
impl Value for bool {
    type Bytes = [u8; 1];
    const BITS: usize = 1;
    const DATA_TYPE: DataType = DataType::BOOLEAN;

    #[inline]
    fn to_bytes(self) -> Self::Bytes {
        [u8::from(self)]
    }

    #[inline]
    fn from_bytes([byte]: Self::Bytes) -> Self {
        byte != 0
    }
}

/// Text that can be written, and what is of an unknown type: the bytes as they are.
impl<const N: usize> Value for [u8; N] {
    type Bytes = Self;
    const DATA_TYPE: DataType = DataType::OCTET_STRING;

    #[inline]
    fn to_bytes(self) -> Self::Bytes {
        self
    }

    #[inline]
    fn from_bytes(bytes: Self::Bytes) -> Self {
        bytes
    }
}

/// Shows a struct around a number of which some values have names, by the number and the name.
///
/// ```
/// struct Code(u16);
///
/// impl Code {
///     fn name(&self) -> Option<&'static str> {
///         (self.0 == 3).then_some("stopped")
///     }
/// }
/// devc_runtime::named!(Code, "{}");
///
/// assert_eq!(Code(3).to_string(), "3: stopped");
/// assert_eq!(Code(4).to_string(), "4: unknown");
/// ```
#[macro_export]
macro_rules! named {
    ($name:ident, $number:literal) => {
        impl ::core::fmt::Display for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                ::core::write!(f, $number, self.0)?;
                f.write_str(": ")?;
                f.write_str(self.name().unwrap_or("unknown"))
            }
        }
    };
}

/// Implements [`Value`](crate::object::Value) for a struct around a number, as generated words and codes are.
///
/// ```
/// use devc_runtime::object::Value;
///
/// #[derive(Clone, Copy)]
/// pub struct Controlword(pub u16);
/// devc_runtime::value!(Controlword as u16);
///
/// assert_eq!(Controlword(0x000F).to_bytes(), [0x0F, 0x00]);
/// ```
#[macro_export]
macro_rules! value {
    ($name:ident as $number:ty) => {
        impl $crate::object::Value for $name {
            type Bytes = <$number as $crate::object::Value>::Bytes;
            const BITS: usize = <$number as $crate::object::Value>::BITS;
            const DATA_TYPE: $crate::sdo::DataType = <$number as $crate::object::Value>::DATA_TYPE;

            #[inline]
            fn to_bytes(self) -> Self::Bytes {
                self.0.to_le_bytes()
            }

            #[inline]
            fn from_bytes(bytes: Self::Bytes) -> Self {
                Self(<$number>::from_le_bytes(bytes))
            }
        }

        impl $crate::sdo::Kept for $name {
            #[inline]
            fn slot(&mut self) -> $crate::sdo::Slot<'_> {
                $crate::sdo::Kept::slot(&mut self.0)
            }
        }
    };
}
