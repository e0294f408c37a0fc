//! Settings outside the dictionary, and the vendor's own numbering of it.

use super::table::table;
use super::{Address, Effective, Index, Kind, Source, Stored, Value, ValueRanges, model};
use crate::source::Origin;

table! {
    /// `[parameters.<id>]`: a setting of the device by the vendor's own name for it.
    pub struct Parameter by id: "a word" {
        /// The word or number for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// Where it lies in the dictionary of the first axis, if the vendor's numbering says so: its only value, or
        /// the first of its elements.
        #[serde(skip_deserializing)]
        pub address: Option<Address>,
        /// What it is made of: one value, or elements of one type or of several.
        pub kind: Option<Kind>,
        /// How many elements it has, which are counted from 0.
        pub elements: Option<u8>,
        /// What it does, and how it is reached.
        pub about: Option<String>,
        /// Its value on delivery.
        pub default: Option<Value>,
        /// The least value.
        pub min: Option<Value>,
        /// The greatest value.
        pub max: Option<Value>,
        /// The unit of its value, as people write it.
        pub symbol: Option<String>,
        /// What its values mean, by value or by range of values.
        #[serde(default)]
        pub values: ValueRanges,
        /// When a new value takes effect.
        pub effective: Option<Effective>,
        /// Whether the device keeps it when it is switched off.
        pub stored: Option<Stored>,
    }
}

impl Parameter {
    /// Whether it has elements, as arrays and records have.
    pub fn has_elements(&self) -> bool {
        self.elements.is_some() || self.kind.is_some_and(|kind| kind != Kind::Var)
    }
}

model! {
    /// How the vendor's parameters lie in the dictionary of the first axis: `E200[0]` has the index
    /// `base + number of group E × group_size + 200`.
    pub struct Coordinates {
        /// The index of the first line of group number 0.
        pub base: Index,
        /// How many lines a group has room for.
        pub group_size: u16,
        /// What is added to the number of an element to get its subindex.
        pub element_shift: u8,
        /// The groups by letter.
        pub groups: Vec<Group>,
        /// How to use it.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// A group of parameters.
    pub struct Group by letter {
        /// Its letter.
        pub letter: String,
        /// What its parameters are about.
        pub name: String,
        /// Its number in the formula; none if its parameters have no index.
        pub number: Option<u16>,
        /// The indices that the manual gives for it on the first axis.
        pub range: Option<(Index, Index)>,
        /// The indices that the manual gives on other axes, where they are not as far apart as the axes are.
        pub per_axis: Vec<AxisGroup>,
    }

    /// Where the manual puts a group on an axis.
    #[derive(Eq)]
    pub struct AxisGroup by axis {
        /// The number of the axis.
        pub axis: u8,
        /// The first index.
        pub first: Index,
        /// The last index.
        pub last: Index,
    }
}

impl Coordinates {
    /// The address of a coordinate such as `E200[0]` or `A515` on the first axis.
    pub fn address(&self, text: &str) -> Option<Address> {
        let number = |letter: &str| self.groups.iter().find(|group| group.letter == letter)?.number;
        coordinate(text, (self.base, self.group_size, self.element_shift), number)
    }
}

/// The address of a coordinate in groups of a size from a base on, whose elements have subindices from a shift on.
pub(crate) fn coordinate(
    text: &str,
    (base, size, shift): (Index, u16, u8),
    number: impl FnOnce(&str) -> Option<u16>,
) -> Option<Address> {
    let (place, subindex) = match text.strip_suffix(']') {
        Some(rest) => {
            let (place, element) = rest.split_once('[')?;
            (place, element.parse::<u8>().ok()?.checked_add(shift)?)
        }
        None => (text, 0),
    };
    let letter = place.get(..1)?;
    let line: u16 = place.get(1..)?.parse().ok().filter(|line| *line < size)?;
    let index = number(letter)?.checked_mul(size)?.checked_add(base.0)?.checked_add(line)?;
    Some(Address { index: Index(index), subindex })
}
