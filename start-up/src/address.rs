//! Where an entry is.

use core::fmt;

/// Index and subindex of an entry (CiA 301, object dictionary). Addresses sort as dictionaries do.
///
/// ```
/// use devc_start_up::Address;
///
/// assert_eq!(Address::new(0x607D, 2).to_string(), "0x607D:02");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// The object.
    pub index: u16,
    /// The entry in the object; 0 for an object that is a single value.
    pub subindex: u8,
}

impl Address {
    /// The address of `index`:`subindex`.
    pub const fn new(index: u16, subindex: u8) -> Self {
        Self { index, subindex }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "0x{:04X}:{:02X}", self.index, self.subindex)
    }
}
