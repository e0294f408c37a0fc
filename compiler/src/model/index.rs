//! Places in the object dictionary.

use std::fmt;

use super::compare::value;
use super::plain;

plain! {
    /// The index of an object.
    #[derive(Copy, Default, Eq, PartialOrd, Ord, Hash)]
    pub struct Index(pub u16);

    /// An index with a subindex.
    #[derive(Copy, Default, Eq, PartialOrd, Ord, Hash)]
    pub struct Address {
        /// The object.
        pub index: Index,
        /// The entry.
        pub subindex: u8,
    }
}

value! { Index Address }

impl From<u16> for Index {
    fn from(index: u16) -> Self {
        Self(index)
    }
}

impl Index {
    /// Whether an object of this index follows from the PDOs and the sync managers.
    pub fn is_derived(self) -> bool {
        matches!(self.0, 0x1600..=0x17FF | 0x1A00..=0x1C00 | 0x1C10..=0x1C13)
    }
}

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "0x{:04X}", self.0)
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{:02X}", self.index, self.subindex)
    }
}
