//! Modes of operation.

use core::fmt;

/// The modes of operation that a device has (CiA 402, modes of operation 0x6060 and its display 0x6061): an enum in
/// the generated module.
///
/// Positive codes are the profile's, negative ones the manufacturer's; 0 is no mode.
pub trait Mode: Copy {
    /// The number on the wire.
    fn code(self) -> i8;

    /// The mode with that number, if the device has it.
    fn from_code(code: i8) -> Option<Self>;

    /// The name that the manual uses.
    fn name(self) -> &'static str;

    /// The mode with that number, or the number with the word that it is not known.
    #[inline]
    fn decode(code: i8) -> Result<Self, UnknownMode> {
        Self::from_code(code).ok_or(UnknownMode(code))
    }
}

/// The number of a mode that the device's description does not have (CiA 402, modes of operation 0x6060).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct UnknownMode(
    /// The number as it came.
    pub i8,
);

impl fmt::Display for UnknownMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown mode of operation {}", self.0)
    }
}

impl core::error::Error for UnknownMode {}
