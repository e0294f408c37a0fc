//! PDOs, and what is mapped to them.

use super::image::refuse;
use super::{Members, ProcessData};
use crate::object::Address;
use crate::text::Text;

/// A single PDO: process data that has an index of its own.
///
/// Where each axis has a PDO of the same shape, there is one type for all, so that a program can go through the axes;
/// the constants are those of the first axis, and the generated type tells the others.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no PDO",
    note = "PDOs are in the module of a device, or structs with `#[derive(Pdo)]`"
)]
pub trait Pdo: ProcessData {
    /// The mapping object, 0x1600 on for received and 0x1A00 on for transmitted PDOs (CiA 301).
    const INDEX: u16;
    /// What is mapped, in order, each as the mapping object holds it: index, subindex and number of bits.
    const MAPPING: &'static [Mapping];

    /// The PDO of each axis, or the only one, with what is mapped to it.
    const ALL: &'static [MappedPdo] = &[MappedPdo::new(Self::INDEX, Self::MAPPING)];

    /// The members of the family that have it.
    const MEMBERS: Members = Members::ALL;
}

/// A PDO with what is mapped to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MappedPdo {
    /// The mapping object.
    pub index: u16,
    /// What is mapped, in order.
    pub mapping: &'static [Mapping],
    /// Whether it is not what the device starts with, so that the master has to write it.
    pub is_own: bool,
    /// The members of the family that have it.
    pub members: Members,
}

impl MappedPdo {
    /// A PDO as the device has it.
    pub const fn new(index: u16, mapping: &'static [Mapping]) -> Self {
        Self { index, mapping, is_own: false, members: Members::ALL }
    }

    /// A PDO as a master has to map it.
    pub const fn own(index: u16, mapping: &'static [Mapping]) -> Self {
        Self { index, mapping, is_own: true, members: Members::ALL }
    }

    /// The PDO of an axis, by number; refuses an axis that has none, so it is for constants.
    #[track_caller]
    pub const fn of_axis<P: Pdo>(axis: u8) -> Self {
        match P::ALL.split_at_checked(axis as usize) {
            Some((_, [pdo, ..])) => Self { members: P::MEMBERS, ..*pdo },
            _ => refuse(
                Text::new()
                    .text("there is no axis ")
                    .number(axis as usize)
                    .text(": ")
                    .hex(P::INDEX)
                    .text(" is that of the first of ")
                    .number(P::ALL.len()),
            ),
        }
    }
}

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
