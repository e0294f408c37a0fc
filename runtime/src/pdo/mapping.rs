//! What is mapped to a PDO.

use crate::object::Address;

/// A mapped entry: what a subindex of a mapping object says (CiA 301, PDO mapping).
///
/// ```
/// use devc_runtime::object::Address;
/// use devc_runtime::pdo::Mapping;
///
/// let target_position = Mapping { address: Address::new(0x607A, 0), bits: 32 };
/// assert_eq!(target_position.word(), 0x607A_0020);
/// assert_eq!(Mapping::from_word(0x607A_0020), target_position);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mapping {
    /// The entry; index 0 stands for a gap.
    pub address: Address,
    /// Its length in bits.
    pub bits: u8,
}

impl Mapping {
    /// Index, subindex and length in one number, the value of the mapping object's subindex.
    pub const fn word(self) -> u32 {
        let [high, low] = self.address.index.to_be_bytes();
        u32::from_be_bytes([high, low, self.address.subindex, self.bits])
    }

    /// The entry that a mapping object's subindex names.
    pub const fn from_word(word: u32) -> Self {
        let [high, low, subindex, bits] = word.to_be_bytes();
        Self { address: Address::new(u16::from_be_bytes([high, low]), subindex), bits }
    }
}
