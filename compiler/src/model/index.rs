//! Places in the object dictionary.

use std::fmt;

use super::model;

model! {
    /// The index of an object.
    #[derive(Copy, Eq, PartialOrd, Ord, Hash)]
    pub struct Index(pub u16);

    /// An index with a subindex.
    #[derive(Copy, Eq, PartialOrd, Ord, Hash)]
    pub struct Address {
        /// The object.
        pub index: Index,
        /// The entry.
        pub subindex: u8,
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
