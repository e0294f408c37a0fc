//! Words made of bits: `[words.<id>]`.

use super::raw;
use crate::model::Fields;

raw! {
    /// `[words.<id>]`: the bits of an object.
    pub struct RawWord {
        /// The object or entry whose bits these are; the id is its name if absent.
        pub object: Option<String>,
        /// Its name; the object's if absent.
        pub name: Option<String>,
        /// The bits, `"0"`, or groups of bits, `"4..=6"`.
        #[serde(default)]
        pub bits: Fields,
        /// What else is to be said of it.
        pub about: Option<String>,
    }
}
