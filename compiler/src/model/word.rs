//! Words made of bits.

use super::{Address, Fields, Source, model};
use crate::source::Origin;

model! {
    /// The bits of an object.
    pub struct Word by id {
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The entry whose bits these are, on the first axis.
        pub address: Address,
        /// The width in bits.
        pub bits: u32,
        /// Its fields, lowest bit first.
        pub fields: Fields,
        /// What else is to be said of it.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }
}
