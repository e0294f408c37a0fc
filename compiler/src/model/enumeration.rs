//! What values mean that several entries share.

use super::Meanings;
use super::table::table;

table! {
    /// `[enumerations.<id>]`: what values mean, for all entries that say `values = "<id>"`.
    pub struct Enumeration by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// What single values mean, by value.
        pub values: Meanings,
    }
}
