//! Settings outside the dictionary, and the vendor's own numbering of it.

use super::{Address, Index, Source, Value, model};
use crate::source::Origin;

model! {
    /// A setting of the device by the vendor's own name for it.
    pub struct Parameter {
        /// The word or number for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// Where it lies in the dictionary of the first axis, if the vendor's numbering says so.
        pub address: Option<Address>,
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
        /// What its values mean.
        pub values: Vec<ValueRange>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// What a value, or each value of a range, means.
    pub struct ValueRange {
        /// The first value.
        pub first: i64,
        /// The last value.
        pub last: i64,
        /// What it is called.
        pub name: String,
        /// What it means in full.
        pub about: Option<String>,
    }

    /// How the vendor's parameters lie in the dictionary of the first axis: `E200[0]` has the index
    /// `base + number of group E × group_size + 200`.
    pub struct Coordinates {
        /// The index of the first line of group number 0.
        pub base: Index,
        /// How many lines a group has room for.
        pub group_size: u16,
        /// What is added to the element to get the subindex in SDO information.
        pub info_shift: u8,
        /// The groups by letter.
        pub groups: Vec<Group>,
        /// How to use it.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// A group of parameters.
    pub struct Group {
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
    pub struct AxisGroup {
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
        let (place, element) = match text.strip_suffix(']') {
            Some(rest) => rest.split_once('[')?,
            None => (text, "0"),
        };
        let letter = place.get(..1)?;
        let line: u16 = place.get(1..)?.parse().ok().filter(|line| *line < self.group_size)?;
        let number = self.groups.iter().find(|group| group.letter == letter)?.number?;
        let index = number.checked_mul(self.group_size)?.checked_add(self.base.0)?.checked_add(line)?;
        Some(Address { index: Index(index), subindex: element.parse().ok()? })
    }
}
