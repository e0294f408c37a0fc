//! Words made of bits: `[words.<id>]`.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::de::{Deserializer, Error};

use super::decode::shorthand;

/// `[words.<id>]`: the bits of an object.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawWord {
    /// The object or entry whose bits these are; the id is its name if absent.
    pub object: Option<String>,
    /// Its name; the object's if absent.
    pub name: Option<String>,
    /// The bits, `"0"`, or groups of bits, `"4..=6"`.
    #[serde(default)]
    pub bits: BTreeMap<String, RawField>,
    /// What else is to be said of it.
    pub about: Option<String>,
}

/// A bit, a group of bits, or a single value: its name alone, or a table.
#[derive(Debug, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename_all = "kebab-case", transform = super::schema::or_text))]
pub struct RawField {
    /// Its name; only what is `reserved` or `per-mode` can do without.
    pub name: String,
    /// What it says or does.
    pub about: Option<String>,
    /// What its values mean.
    pub values: BTreeMap<String, RawField>,
    /// What happens when it goes from 0 to 1.
    pub rising: Option<String>,
    /// What happens when it goes from 1 to 0.
    pub falling: Option<String>,
    /// Whether it has no meaning.
    pub reserved: bool,
    /// Whether its meaning depends on the mode of operation, see `control-bits` and `status-bits` of a mode.
    pub per_mode: bool,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
struct FieldTable {
    name: Option<String>,
    about: Option<String>,
    #[serde(default)]
    values: BTreeMap<String, RawField>,
    rising: Option<String>,
    falling: Option<String>,
    #[serde(default)]
    reserved: bool,
    #[serde(default)]
    per_mode: bool,
}

impl<'de> Deserialize<'de> for RawField {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let table: FieldTable = shorthand(deserializer, "name", "a name, or a table with a `name`")?;
        let name = match table.name {
            Some(name) => name,
            None if table.reserved => "reserved".to_owned(),
            None if table.per_mode => "mode-specific".to_owned(),
            None => return Err(Error::missing_field("name")),
        };
        Ok(Self {
            name,
            about: table.about,
            values: table.values,
            rising: table.rising,
            falling: table.falling,
            reserved: table.reserved,
            per_mode: table.per_mode,
        })
    }
}
