//! Bits and groups of bits.

use serde::Deserialize;
use serde::de::{Deserializer, Error};

use super::ids::Siblings;
use super::keyed::{Range, keyed, list};
use super::shorthand::shorthand;
use super::{Meanings, model};

model! {
    /// A bit or a group of bits.
    pub struct Field by low {
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
        pub values: Meanings,
        /// What happens when it goes from 0 to 1.
        pub rising: Option<String>,
        /// What happens when it goes from 1 to 0.
        pub falling: Option<String>,
        /// Whether it has no meaning.
        pub reserved: bool,
        /// Whether its meaning depends on the mode of operation.
        pub per_mode: bool,
        /// The key that it stands under.
        #[cfg_attr(feature = "json", serde(skip))]
        pub key: String,
    }
}

impl Field {
    /// The width in bits.
    pub fn width(&self) -> u8 {
        self.high.saturating_sub(self.low).saturating_add(1)
    }

    /// Its path in a table that has its bits under a key.
    pub fn path(&self, bits: &str) -> String {
        format!("{bits}.{}", self.key)
    }

    /// Its bits within the word.
    pub fn mask(&self) -> u64 {
        (self.low..=self.high).filter_map(|bit| 1_u64.checked_shl(bit.into())).sum()
    }
}

/// A bit or a group of bits: its name alone, or a table.
#[derive(Debug, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "Bits", rename_all = "kebab-case", transform = super::schema::or_text))]
pub(crate) struct Described {
    /// Its name; only what is `reserved` or `per-mode` can do without.
    name: String,
    /// What it says or does.
    about: Option<String>,
    /// What its values mean.
    values: Meanings,
    /// What happens when it goes from 0 to 1.
    rising: Option<String>,
    /// What happens when it goes from 1 to 0.
    falling: Option<String>,
    /// Whether it has no meaning.
    reserved: bool,
    /// Whether its meaning depends on the mode of operation, see `control-bits` and `status-bits` of a mode.
    per_mode: bool,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
struct DescribedTable {
    name: Option<String>,
    about: Option<String>,
    #[serde(default)]
    values: Meanings,
    rising: Option<String>,
    falling: Option<String>,
    #[serde(default)]
    reserved: bool,
    #[serde(default)]
    per_mode: bool,
}

impl<'de> Deserialize<'de> for Described {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let table: DescribedTable = shorthand(deserializer, "name", "a name, or a table with a `name`")?;
        let DescribedTable { name, about, values, rising, falling, reserved, per_mode } = table;
        let name = match name {
            Some(name) => name,
            None if reserved => "reserved".to_owned(),
            None if per_mode => "mode-specific".to_owned(),
            None => return Err(Error::missing_field("name")),
        };
        Ok(Self { name, about, values, rising, falling, reserved, per_mode })
    }
}

list! {
    /// Bits and groups of bits, the lowest first.
    Fields of Field as Described;
}

impl<'de> Deserialize<'de> for Fields {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut described: Vec<(Range<Bit>, Described)> = keyed(deserializer)?;
        described.sort_by_key(|(range, _)| range.first);
        let mut ids = Siblings::default();
        let field = |(Range { first: Bit(low), last: Bit(high), key }, described)| {
            let Described { name, about, values, rising, falling, reserved, per_mode } = described;
            let id = ids.claim(&name);
            Field { low, high, id, name, about, values, rising, falling, reserved, per_mode, key }
        };
        Ok(Self(described.into_iter().map(field).collect()))
    }
}

/// The number of a bit, or of a byte of a message: below 64.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Bit(u8);

impl TryFrom<i64> for Bit {
    type Error = ();

    fn try_from(number: i64) -> Result<Self, ()> {
        u8::try_from(number).ok().filter(|number| *number < 64).map(Self).ok_or(())
    }
}
