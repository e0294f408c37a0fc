//! Dictionaries whose indices follow from a vendor's own numbering: `[coordinates]`.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::raw;
use crate::model::{Address, Index, coordinate};

raw! {
    /// `[coordinates]`: how the vendor's parameters lie in the dictionary. `E200[0]` is line 200 of group E,
    /// element 0; its index is `base + group number × group-size + line`.
    pub struct RawCoordinates {
        /// The index of the first line of group number 0.
        pub base: u16,
        /// How many lines a group has room for.
        pub group_size: u16,
        /// What is added to the number of an element to get its subindex; a parameter without elements has
        /// subindex 0.
        #[serde(default)]
        pub element_shift: u8,
        /// The groups by letter.
        #[serde(default)]
        pub groups: BTreeMap<String, RawGroup>,
        /// How to use it.
        pub about: Option<String>,
    }
}

/// A group of parameters.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawGroup {
    /// What its parameters are about.
    pub name: String,
    /// Its number in the formula; none if its parameters have no index.
    pub number: Option<u16>,
    /// The indices that the manual gives for it on the first axis, as `"0x2000..=0x21FF"`.
    pub range: Option<String>,
    /// Axes for which the manual gives other indices than the distance between the axes makes, by name.
    #[serde(default)]
    pub per_axis: BTreeMap<String, RawAxisGroup>,
}

/// What differs on an axis.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawAxisGroup {
    /// The indices that the manual gives for the group on this axis.
    pub range: String,
}

impl RawCoordinates {
    /// The address of a coordinate such as `E200[0]` or `A515` on the first axis.
    pub(crate) fn address(&self, text: &str) -> Option<Address> {
        let number = |letter: &str| self.groups.get(letter)?.number;
        coordinate(text, (Index(self.base), self.group_size, self.element_shift), number)
    }
}
