//! PDOs, and what is mapped to them.

use crate::{Address, Members};

/// A PDO with what is mapped to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MappedPdo<'a> {
    /// The mapping object.
    pub index: u16,
    /// What is mapped, in order.
    pub mapping: &'a [Mapping],
    /// Whether it is not what the device starts with, so that the master has to write it.
    pub is_own: bool,
    /// The members of the family that have it.
    pub members: Members,
}

impl<'a> MappedPdo<'a> {
    /// A PDO as the device has it.
    pub const fn new(index: u16, mapping: &'a [Mapping]) -> Self {
        Self { index, mapping, is_own: false, members: Members::ALL }
    }

    /// A PDO as a master has to map it.
    pub const fn own(index: u16, mapping: &'a [Mapping]) -> Self {
        Self { is_own: true, ..Self::new(index, mapping) }
    }
}

/// A mapped entry: what a subindex of a mapping object says (CiA 301, PDO mapping).
///
/// ```
/// use devc_start_up::{Address, Mapping};
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
    /// Bits that nobody reads or writes (ETG.1000.6, PDO mapping: index 0, subindex 0).
    pub const fn gap(bits: u8) -> Self {
        Self { address: Address::new(0, 0), bits }
    }

    /// Whether it is a gap.
    pub const fn is_gap(self) -> bool {
        self.address.index == 0 && self.address.subindex == 0
    }

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

/// Whether a list of PDOs names one.
pub(crate) const fn has(mut pdos: &[u16], pdo: u16) -> bool {
    while let Some((index, rest)) = pdos.split_first() {
        if *index == pdo {
            return true;
        }
        pdos = rest;
    }
    false
}
