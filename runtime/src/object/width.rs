//! Numbers of widths that Rust has no type for: a few bits, and three, five, six or seven bytes.

use core::cmp::Ordering;
use core::fmt;

use super::Value;
use crate::sdo::{DataType, Kept, Slot};

macro_rules! width {
    ($(#[$doc:meta])* $name:ident, $number:ident, $data_type:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name<const BITS: usize, const BYTES: usize>([u8; BYTES]);

        impl<const BITS: usize, const BYTES: usize> $name<BITS, BYTES> {
            /// The bits of the number that are none of this type's.
            const ABOVE: u32 = {
                assert!(matches!(BITS, 2..=7 | 24 | 40 | 48 | 56), "there is no type of this width");
                assert!(BITS.div_ceil(8) == BYTES, "the bytes are not those of the bits");
                64 - BITS as u32
            };

            /// The least number.
            pub const MIN: Self = Self::from_low_bits(($number::MIN >> Self::ABOVE) as u64);

            /// The greatest number.
            pub const MAX: Self = Self::from_low_bits(($number::MAX >> Self::ABOVE) as u64);

            /// The number in this type, if it fits.
            #[inline]
            pub const fn new(number: $number) -> Option<Self> {
                let value = Self::from_low_bits(number as u64);
                if value.get() == number { Some(value) } else { None }
            }

            /// The number in this type; one that does not fit does not compile.
            pub const fn of<const NUMBER: $number>() -> Self {
                const { assert!(Self::new(NUMBER).is_some(), "the number does not fit the bits") };
                Self::from_low_bits(NUMBER as u64)
            }

            /// The number in this type, or the end of the range that is nearer to it.
            #[inline]
            pub const fn saturating(number: $number) -> Self {
                match Self::new(number) {
                    Some(value) => value,
                    None if number < Self::MIN.get() => Self::MIN,
                    None => Self::MAX,
                }
            }

            /// The number that the lowest bits are; those above do not count.
            #[inline]
            pub const fn from_low_bits(bits: u64) -> Self {
                Self::from_le_bytes(match bits.to_le_bytes().first_chunk() {
                    Some(bytes) => *bytes,
                    None => [0; BYTES],
                })
            }

            /// The number.
            #[inline]
            pub const fn get(self) -> $number {
                let mut bytes = [0; 8];
                if let Some(low) = bytes.first_chunk_mut() {
                    *low = self.0;
                }
                $number::from_le_bytes(bytes) << Self::ABOVE >> Self::ABOVE
            }

            /// The number as it travels, little-endian; bits above it are copies of the sign, if it has one, or 0.
            #[inline]
            pub const fn to_le_bytes(self) -> [u8; BYTES] {
                match self.get().to_le_bytes().first_chunk() {
                    Some(bytes) => *bytes,
                    None => [0; BYTES],
                }
            }

            /// The number from how it travels; bits above it do not count.
            #[inline]
            pub const fn from_le_bytes(bytes: [u8; BYTES]) -> Self {
                Self(bytes)
            }

            /// The bytes in which the number is kept, little-endian, for a dictionary to write: whatever they are, they
            /// are a number.
            #[inline]
            pub const fn as_bytes_mut(&mut self) -> &mut [u8; BYTES] {
                &mut self.0
            }
        }

        impl<const BITS: usize, const BYTES: usize> Kept for $name<BITS, BYTES> {
            #[inline]
            fn slot(&mut self) -> Slot<'_> {
                Slot::Bytes(self.as_bytes_mut())
            }
        }

        impl<const BITS: usize, const BYTES: usize> Value for $name<BITS, BYTES> {
            type Bytes = [u8; BYTES];
            const BITS: usize = BITS;
            const DATA_TYPE: DataType = $data_type(BITS);

            #[inline]
            fn to_bytes(self) -> Self::Bytes {
                self.to_le_bytes()
            }

            #[inline]
            fn from_bytes(bytes: Self::Bytes) -> Self {
                Self::from_le_bytes(bytes)
            }
        }

        impl<const BITS: usize, const BYTES: usize> From<$name<BITS, BYTES>> for $number {
            fn from(value: $name<BITS, BYTES>) -> Self {
                value.get()
            }
        }

        impl<const BITS: usize, const BYTES: usize> PartialEq for $name<BITS, BYTES> {
            fn eq(&self, other: &Self) -> bool {
                self.get() == other.get()
            }
        }

        impl<const BITS: usize, const BYTES: usize> Eq for $name<BITS, BYTES> {}

        impl<const BITS: usize, const BYTES: usize> PartialOrd for $name<BITS, BYTES> {
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                Some(self.cmp(other))
            }
        }

        impl<const BITS: usize, const BYTES: usize> Ord for $name<BITS, BYTES> {
            fn cmp(&self, other: &Self) -> Ordering {
                self.get().cmp(&other.get())
            }
        }

        impl<const BITS: usize, const BYTES: usize> core::hash::Hash for $name<BITS, BYTES> {
            fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
                self.get().hash(state);
            }
        }

        impl<const BITS: usize, const BYTES: usize> fmt::Debug for $name<BITS, BYTES> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Debug::fmt(&self.get(), f)
            }
        }

        impl<const BITS: usize, const BYTES: usize> fmt::Display for $name<BITS, BYTES> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(&self.get(), f)
            }
        }
    };
}

width! {
    /// A number with a sign, of so many bits in so many bytes. One that does not fit cannot be made.
    ///
    /// ```
    /// use devc_runtime::object::{Int24, Value};
    ///
    /// let number = Int24::of::<-2>();
    /// assert_eq!((number.get(), number.to_bytes()), (-2, [0xFE, 0xFF, 0xFF]));
    /// assert_eq!(Int24::new(0x80_0000), None);
    /// assert_eq!(Int24::saturating(0x80_0000).get(), 0x7F_FFFF);
    /// ```
    Int, i64, integer
}

width! {
    /// A number without a sign, of so many bits in so many bytes. One that does not fit cannot be made.
    ///
    /// ```
    /// use devc_runtime::object::{Bit3, Value};
    ///
    /// assert_eq!((Bit3::BITS, Bit3::SIZE, Bit3::MAX.get()), (3, 1, 7));
    /// assert_eq!(Bit3::new(8), None);
    /// ```
    ///
    /// ```compile_fail,E0080
    /// let number = devc_runtime::object::Bit3::of::<8>();
    /// ```
    Uint, u64, unsigned
}

const fn integer(bits: usize) -> DataType {
    match bits {
        24 => DataType::INTEGER24,
        40 => DataType::INTEGER40,
        48 => DataType::INTEGER48,
        _ => DataType::INTEGER56,
    }
}

/// ETG.1020, base data types, has BIT1 to BIT8 from 0x0030 on.
const fn unsigned(bits: usize) -> DataType {
    match bits {
        24 => DataType::UNSIGNED24,
        40 => DataType::UNSIGNED40,
        48 => DataType::UNSIGNED48,
        56 => DataType::UNSIGNED56,
        bits => DataType(0x2F + bits as u16),
    }
}

macro_rules! names {
    ($($name:ident = $width:ident<$bits:literal, $bytes:literal>, $doc:literal;)+) => {$(
        #[doc = $doc]
        pub type $name = $width<$bits, $bytes>;
    )+};
}

names! {
    Bit2 = Uint<2, 1>, "BIT2: two bits in process data, a byte in an SDO.";
    Bit3 = Uint<3, 1>, "BIT3: three bits in process data, a byte in an SDO.";
    Bit4 = Uint<4, 1>, "BIT4: four bits in process data, a byte in an SDO.";
    Bit5 = Uint<5, 1>, "BIT5: five bits in process data, a byte in an SDO.";
    Bit6 = Uint<6, 1>, "BIT6: six bits in process data, a byte in an SDO.";
    Bit7 = Uint<7, 1>, "BIT7: seven bits in process data, a byte in an SDO.";
    Int24 = Int<24, 3>, "INTEGER24: signed, 3 bytes.";
    Int40 = Int<40, 5>, "INTEGER40: signed, 5 bytes.";
    Int48 = Int<48, 6>, "INTEGER48: signed, 6 bytes.";
    Int56 = Int<56, 7>, "INTEGER56: signed, 7 bytes.";
    Uint24 = Uint<24, 3>, "UNSIGNED24: unsigned, 3 bytes.";
    Uint40 = Uint<40, 5>, "UNSIGNED40: unsigned, 5 bytes.";
    Uint48 = Uint<48, 6>, "UNSIGNED48: unsigned, 6 bytes.";
    Uint56 = Uint<56, 7>, "UNSIGNED56: unsigned, 7 bytes.";
}
