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
    /// The index that is meant by a number without `0x`: up to four digits are hexadecimal, as manuals print them, five are
    /// decimal.
    pub(crate) fn meant(text: &str) -> Option<Self> {
        let radix = if text.len() > 4 { 10 } else { 16 };
        let is_number = text.len() >= 4 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        u16::from_str_radix(text, radix).ok().filter(|_| is_number).map(Self)
    }

    /// Whether an object of this index follows from the PDOs and the sync managers.
    pub fn is_derived(self) -> bool {
        matches!(self.0, 0x1600..=0x1C00 | 0x1C10..=0x1C1F)
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

#[cfg(test)]
mod tests {
    use super::Index;

    #[test]
    fn numbers_without_0x_mean_indices() {
        let pairs = [
            ("24640", Some(0x6040)),
            ("6040", Some(0x6040)),
            ("607a", Some(0x607A)),
            ("65535", Some(0xFFFF)),
        ];
        for (text, meant) in pairs {
            assert_eq!(Index::meant(text), meant.map(Index), "{text}");
        }
        for text in ["", "64", "+123", "65536", "2000:1", "speed", "0x6040"] {
            assert_eq!(Index::meant(text), None, "{text}");
        }
    }
}
