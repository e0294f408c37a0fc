//! Axes, and how they share the dictionary.

use super::{Index, model};
use crate::source::Origin;

model! {
    /// An axis of a device.
    pub struct Axis {
        /// Its number, from 0.
        pub number: u8,
        /// Its name.
        pub name: String,
        /// What it does.
        pub about: Option<String>,
    }

    /// A range of indices that exists once for each axis.
    pub struct Shift {
        /// The first index of the first axis.
        pub first: Index,
        /// The last index of the first axis.
        pub last: Index,
        /// The distance from an axis to the next.
        pub by: u16,
    }

    /// A title for a range of the dictionary.
    pub struct Area {
        /// The first index.
        pub first: Index,
        /// The last index.
        pub last: Index,
        /// The title.
        pub name: String,
        /// What the objects in it are for.
        pub about: Option<String>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }
}
