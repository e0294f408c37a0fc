//! Numbers as they travel.

use core::fmt;

use crate::object::{Int, Uint};

mod sealed {
    pub trait Sealed {}
}

/// A whole number of an entry: every integer type but `u64`, whose upper half no conversion reaches.
pub trait Raw: Copy + sealed::Sealed {
    /// The number as an `i64`.
    fn widen(self) -> i64;

    /// The number in this type, if it fits.
    fn narrow(number: i64) -> Option<Self>;

    /// The number in this type, or the end of the range that is nearer to it.
    fn saturate(number: i64) -> Self;
}

macro_rules! raw {
    ($($type:ty),+) => {$(
        impl sealed::Sealed for $type {}

        impl Raw for $type {
            #[inline]
            fn widen(self) -> i64 {
                i64::from(self)
            }

            #[inline]
            fn narrow(number: i64) -> Option<Self> {
                Self::try_from(number).ok()
            }

            #[inline]
            fn saturate(number: i64) -> Self {
                Self::try_from(number).unwrap_or(if number < 0 { Self::MIN } else { Self::MAX })
            }
        }
    )+};
}

raw!(i8, i16, i32, i64, u8, u16, u32);

impl<const BITS: usize, const BYTES: usize> sealed::Sealed for Int<BITS, BYTES> {}

impl<const BITS: usize, const BYTES: usize> Raw for Int<BITS, BYTES> {
    #[inline]
    fn widen(self) -> i64 {
        self.get()
    }

    #[inline]
    fn narrow(number: i64) -> Option<Self> {
        Self::new(number)
    }

    #[inline]
    fn saturate(number: i64) -> Self {
        Self::saturating(number)
    }
}

impl<const BITS: usize, const BYTES: usize> sealed::Sealed for Uint<BITS, BYTES> {}

impl<const BITS: usize, const BYTES: usize> Raw for Uint<BITS, BYTES> {
    #[inline]
    fn widen(self) -> i64 {
        // of at most 56 bits
        self.get() as i64
    }

    #[inline]
    fn narrow(number: i64) -> Option<Self> {
        Self::new(number.try_into().ok()?)
    }

    #[inline]
    fn saturate(number: i64) -> Self {
        Self::saturating(number.try_into().unwrap_or(0))
    }
}

/// Why a physical value has no raw number, or the other way round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Unfit {
    /// It lies between two numbers.
    Inexact,
    /// It is beyond the range of the numbers.
    OutOfRange,
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Inexact => "the value lies between two raw numbers",
            Self::OutOfRange => "the value is out of range",
        })
    }
}

impl core::error::Error for Unfit {}
