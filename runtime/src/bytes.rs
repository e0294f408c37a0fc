//! Arrays of bytes: what a value or a process image is on the wire.

use core::fmt;

mod sealed {
    pub trait Sealed {}
    impl<const N: usize> Sealed for [u8; N] {}
}

/// An array `[u8; N]`, for code that is generic over N without naming it.
pub trait ByteArray: Copy + AsRef<[u8]> + AsMut<[u8]> + sealed::Sealed + 'static {
    /// Number of bytes.
    const LEN: usize;

    /// All bytes 0.
    const ZERO: Self;

    /// The slice as an array, if it has exactly this many bytes.
    fn from_slice(bytes: &[u8]) -> Result<&Self, WrongLength>;

    /// The slice as an array to write into, if it has exactly this many bytes.
    fn from_slice_mut(bytes: &mut [u8]) -> Result<&mut Self, WrongLength>;
}

impl<const N: usize> ByteArray for [u8; N] {
    const LEN: usize = N;
    const ZERO: Self = [0; N];

    #[inline]
    fn from_slice(bytes: &[u8]) -> Result<&Self, WrongLength> {
        bytes.try_into().map_err(|_| WrongLength { expected: N, found: bytes.len() })
    }

    #[inline]
    fn from_slice_mut(bytes: &mut [u8]) -> Result<&mut Self, WrongLength> {
        let found = bytes.len();
        bytes.try_into().map_err(|_| WrongLength { expected: N, found })
    }
}

/// Data has not the length that its type has on the wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WrongLength {
    /// Bytes that the type takes.
    pub expected: usize,
    /// Bytes that were there.
    pub found: usize,
}

impl fmt::Display for WrongLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected {} bytes, found {}", self.expected, self.found)
    }
}

impl core::error::Error for WrongLength {}

/// Copies as much as there is and as there is room for, and tells how much that is. Unlike `copy_from_slice`, which
/// stops where lengths differ, it has no way to panic.
#[inline]
pub(crate) fn copy(to: &mut [u8], from: &[u8]) -> usize {
    let length = to.len().min(from.len());
    to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
    length
}
