//! Words made of bits, and values with meanings.

use super::{Address, Source, model};
use crate::source::Origin;

model! {
    /// The bits of an object.
    pub struct Word {
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The entry whose bits these are, on the first axis.
        pub address: Address,
        /// The width in bits.
        pub bits: u32,
        /// Its fields, lowest bit first.
        pub fields: Vec<Field>,
        /// What else is to be said of it.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// A bit or a group of bits.
    pub struct Field {
        /// The lowest bit.
        pub low: u8,
        /// The highest bit.
        pub high: u8,
        /// The word for it, unique within the word.
        pub id: String,
        /// Its name.
        pub name: String,
        /// What it says or does.
        pub about: Option<String>,
        /// What its values mean.
        pub values: Vec<Meaning>,
        /// What happens when it goes from 0 to 1.
        pub rising: Option<String>,
        /// What happens when it goes from 1 to 0.
        pub falling: Option<String>,
        /// Whether it has no meaning.
        pub reserved: bool,
        /// Whether its meaning depends on the mode of operation.
        pub per_mode: bool,
        /// Where it was written, as a path in the word's origin.
        #[cfg_attr(feature = "json", serde(skip))]
        pub path: String,
    }

    /// What a value means.
    pub struct Meaning {
        /// The value.
        pub value: i64,
        /// The word for it, unique among its siblings.
        pub id: String,
        /// Its name.
        pub name: String,
        /// What it means in full.
        pub about: Option<String>,
    }
}

impl Field {
    /// The width in bits.
    pub fn width(&self) -> u8 {
        self.high.saturating_sub(self.low).saturating_add(1)
    }

    /// Its bits within the word.
    pub fn mask(&self) -> u64 {
        (self.low..=self.high).filter_map(|bit| 1_u64.checked_shl(bit.into())).sum()
    }
}
