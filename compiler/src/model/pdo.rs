//! Process data objects.

use std::ops::RangeInclusive;

use devc_start_up::Mapping;

use super::table::part;
use super::{Address, DataType, Index, Source, Translations, model};
use crate::source::Origin;

model! {
    /// A process data object.
    pub struct Pdo by index {
        /// Its index.
        pub index: Index,
        /// The index of the PDO that was written for all axes; its own if it is there once.
        pub leading: Index,
        /// Who sends it.
        pub direction: Direction,
        /// Its name.
        pub name: String,
        /// Its name in other languages, by language.
        pub names: Translations,
        /// The axis it is for, if each has one.
        pub axis: Option<u8>,
        /// What is in it, in order.
        pub entries: Vec<Mapped>,
        /// Whether its mapping cannot be changed.
        pub fixed: bool,
        /// Whether it cannot be taken out of its sync manager.
        pub mandatory: bool,
        /// The PDOs that cannot be assigned together with it, by index.
        pub excludes: Vec<Index>,
        /// The mode of operation it is meant for.
        pub mode: Option<i16>,
        /// The number of bytes that the manual gives for it.
        pub total: Option<u16>,
        /// The largest number of bytes it can be mapped to.
        pub max_bytes: Option<u16>,
        /// The largest number of entries it can be mapped to.
        pub max_entries: Option<u8>,
        /// The sync unit it belongs to.
        pub sync_unit: Option<String>,
        /// Whether it is there for a master's own programs only, and the device knows nothing of it.
        pub r#virtual: bool,
        /// How often its values can be there in a cycle, if they can be several times.
        pub oversampling: Option<Oversampling>,
        /// What it is for.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// An entry of a PDO.
    pub struct Mapped {
        /// What is mapped; none for padding.
        pub address: Option<Address>,
        /// Its name.
        pub name: String,
        /// Its name in other languages, by language.
        pub names: Translations,
        /// The word for it, unique within the PDO.
        pub id: String,
        /// The first bit within the PDO.
        pub offset: u32,
        /// The width in bits.
        pub bits: u32,
        /// The type; none for padding, and for what is not in the dictionary and is not said to have one.
        pub data_type: Option<DataType>,
        /// The type that the PDO says it has, where that is not its object's.
        pub own_type: Option<DataType>,
        /// What it is for in this PDO.
        pub about: Option<String>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// Who sends a PDO.
    #[derive(Copy, Eq, PartialOrd, Ord)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum Direction {
        /// The master: a receive PDO, an output.
        Rx,
        /// The device: a transmit PDO, an input.
        Tx,
    }
}

part! {
    /// How often the values of a PDO can be there in a cycle.
    #[derive(Copy, Eq)]
    pub struct Oversampling {
        /// How often they are if nothing is chosen.
        pub factor: u16,
        /// How often at least.
        pub min: Option<u16>,
        /// How often at most.
        pub max: Option<u16>,
        /// How far the indices of what is there several times are apart.
        pub step: Option<u16>,
    }
}

impl Direction {
    /// The indices that ETG.1000.6 has for its PDOs.
    pub fn indices(self) -> RangeInclusive<u16> {
        match self {
            Self::Rx => 0x1600..=0x17FF,
            Self::Tx => 0x1A00..=0x1BFF,
        }
    }
}

impl Mapped {
    /// What is left free is called so, unless a description gives it a name.
    pub const PADDING: &str = "Padding";

    /// The type that masters are told: the PDO's own, else that of the object.
    pub fn told_type(&self) -> Option<DataType> {
        self.own_type.or(self.data_type)
    }

    /// The entry as a mapping object has it.
    pub(crate) fn mapping(&self) -> Mapping {
        let [bits, ..] = self.bits.to_le_bytes();
        match self.address {
            Some(Address { index, subindex }) => {
                Mapping { address: devc_start_up::Address::new(index.0, subindex), bits }
            }
            None => Mapping::gap(bits),
        }
    }
}

impl Pdo {
    /// What a mapping object, or an assignment, has room for: subindices 1 to 254, since 0 is their number and CiA 301 keeps
    /// 255 for itself.
    pub(crate) const ROOM: usize = 254;

    /// The width in bits.
    pub fn bits(&self) -> u32 {
        self.entries.iter().map(|entry| entry.bits).sum()
    }

    /// The width in whole bytes.
    pub fn bytes(&self) -> u32 {
        self.bits().div_ceil(8)
    }
}
