//! What single values, and ranges of values, mean.

mod notation;

pub use notation::Notation;
use serde::Deserialize;
use serde::de::Deserializer;

use super::ids::Siblings;
use super::keyed::{Number, Range, keyed, list};
use super::shorthand::shorthand;
use super::{Translations, model};

model! {
    /// What a value means.
    pub struct Meaning by value {
        /// The value.
        pub value: i64,
        /// How the value is written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub notation: Notation,
        /// The word for it, unique among its siblings.
        pub id: String,
        /// Its name.
        pub name: String,
        /// Its name in other languages, by language.
        pub names: Translations,
        /// What it means in full.
        pub about: Option<String>,
    }

    /// What a value, or each value of a range, means.
    pub struct ValueRange by first {
        /// The first value.
        pub first: i64,
        /// The last value.
        pub last: i64,
        /// How both are written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub notation: Notation,
        /// What it is called.
        pub name: String,
        /// And in other languages, by language.
        pub names: Translations,
        /// What it means in full.
        pub about: Option<String>,
    }
}

/// What a value means: its name alone, or a table.
#[derive(Debug, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "ValueMeaning", transform = super::schema::or_text))]
pub(crate) struct Named {
    /// Its name.
    name: String,
    /// Its name in other languages, by language.
    names: Translations,
    /// What it means in full.
    about: Option<String>,
}

#[derive(Deserialize)]
struct NamedTable {
    name: String,
    #[serde(default)]
    names: Translations,
    about: Option<String>,
}

impl<'de> Deserialize<'de> for Named {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let NamedTable { name, names, about } =
            shorthand(deserializer, "name", "a name, or a table with a `name`")?;
        Ok(Self { name, names, about })
    }
}

list! {
    /// What single values mean, by value.
    Meanings of Meaning as Named;
    /// What values and ranges of values mean, by the first value.
    ValueRanges of ValueRange as Named;
}

impl<'de> Deserialize<'de> for Meanings {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut named: Vec<(Number, Named)> = keyed(deserializer)?;
        named.sort_by_key(|(number, _)| number.value);
        let mut ids = Siblings::default();
        let meaning = |(Number { value, key }, Named { name, names, about })| Meaning {
            value,
            notation: Notation::of(&key),
            id: ids.claim(&name),
            name,
            names,
            about,
        };
        Ok(Self(named.into_iter().map(meaning).collect()))
    }
}

impl<'de> Deserialize<'de> for ValueRanges {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let named: Vec<(Range<i64>, Named)> = keyed(deserializer)?;
        let range = |(Range { first, last, key }, Named { name, names, about })| ValueRange {
            first,
            last,
            notation: Notation::of(&key),
            name,
            names,
            about,
        };
        let mut ranges: Vec<ValueRange> = named.into_iter().map(range).collect();
        ranges.sort_by_key(|range| range.first);
        Ok(Self(ranges))
    }
}
