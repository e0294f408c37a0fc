//! The object dictionary: `[objects.<index>]` and its entries.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::values::RawValues;
use crate::model::{
    Access, Category, Effective, Index, Kind, Literal, Mappable, Property, Safety, SdoAccess, Source, Stored,
    Translations, WriteWindow,
};
use crate::source::Origin;

/// An object as written: what makes it an object, and its values.
#[derive(Debug)]
pub struct RawObject {
    /// The key that it stands under.
    pub key: String,
    /// Its index on the first axis.
    pub index: Index,
    /// What makes it an object.
    pub head: RawObjectHead,
    /// Its value; of a record or an array what is said of the object as a whole.
    pub value: RawEntry,
    /// Its entries, in the order in which they were written.
    pub entries: Vec<RawEntries>,
    /// What the object's table says for all entries.
    pub shared: RawEntries,
    /// The whole object as it is on some axes: the axes as written, and the object with what differs there laid over.
    pub per_axis: Vec<(String, RawObject)>,
    /// Where its facts are from.
    pub source: Option<Source>,
    /// Where it was written.
    pub origin: Origin,
}

/// An entry, or a range of entries that are alike.
#[derive(Debug)]
pub struct RawEntries {
    /// The first and the last subindex.
    pub range: (u8, u8),
    /// Whether it is written as a range, so that names and parameters are numbered.
    pub many: bool,
    /// What is said of each, in its table or for all entries in the object's.
    pub value: RawEntry,
    /// Where its facts are from, if not where the object's are.
    pub source: Option<Source>,
    /// Where it was written: its table with what the object's says for all entries.
    pub origin: Origin,
}

/// `[objects.<index>]`: an object of the dictionary. The keys `name` and from `type` to `parameter` say what its value
/// is; the tables in `entries` have them, too. For a record or an array `type`, `access`, `pdo`, `safety`, `category`, `unit`, `default`, `min`,
/// `max`, `values`, `written`, `backup`, `setting`, `effective`, `stored`, `functional` and `trigger` hold for all entries that do not
/// say otherwise, but for subindex 0.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawObjectHead {
    /// The word by which the rest of the description refers to it; made from the name if absent.
    pub id: Option<String>,
    /// `"var"`, `"array"` or `"record"`; what the entries look like if absent.
    pub kind: Option<Kind>,
    /// The entries by subindex, `"1"`, or by a range of them, `"1..=16"`, in whose `name`, `parameter`, `default`, `min` and
    /// `max` `{}`, `{+8}` or `{-1:02}` is a number; none for a single value.
    #[serde(default)]
    pub entries: BTreeMap<String, Ignored>,
    /// How its entries are to be transferred, `"complete"` or `"single"`; left to the master if absent.
    pub sdo_access: Option<SdoAccess>,
    /// What differs on some axes, by axis name, `"Y"`, or by a range of them, `"Y..=W"`.
    #[serde(default)]
    pub per_axis: BTreeMap<String, Ignored>,
}

/// A table whose members are read one by one; only its key is known here.
#[derive(Debug, Default, Clone, Copy)]
pub struct Ignored;

impl<'de> Deserialize<'de> for Ignored {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        serde::de::IgnoredAny::deserialize(deserializer).map(|_| Self)
    }
}

/// A value that an index and a subindex name.
#[derive(Debug, Default, Clone, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawEntry {
    /// Its name.
    pub name: Option<String>,
    /// Its name in other languages, by language: `{ de = "..." }`.
    #[serde(default)]
    pub names: Translations,
    /// Its data type: `BOOL`, `INT8` to `INT64`, `UINT8` to `UINT64`, `REAL32`, `REAL64`, `BYTE`, `WORD`,
    /// `DWORD`, `BIT1` to `BIT8`, `STRING`, `STRING(n)`, `OCTET_STRING(n)` with n bytes, `UNICODE_STRING(n)` with n units of 16 bits, or
    /// n numbers as one value: `ARRAY_OF_INT8(n)`, `ARRAY_OF_INT16(n)`, `ARRAY_OF_INT32(n)` or `ARRAY_OF_UINT32(n)`.
    pub r#type: Option<String>,
    /// `"ro"`, `"wo"`, `"rw"` or `"const"`.
    pub access: Option<Access>,
    /// The process data it can be mapped to: `"rx"`, `"tx"`, `"rx-tx"` or `"none"`. Where the description does not say it
    /// and no mapping can be changed, it is what the PDOs carry.
    pub pdo: Option<Mappable>,
    /// What it is to the safety of a machine: `"inputs"`, `"outputs"`, `"inputs-outputs"` or `"parameters"`; nothing if
    /// absent.
    pub safety: Option<Safety>,
    /// Whether the profile demands it: `"mandatory"`, `"optional"` or `"conditional"`.
    pub category: Option<Category>,
    /// The unit of its value, one of `[units]`.
    pub unit: Option<String>,
    /// The value after start-up. A number can be written as a manual prints it in two columns, `"0x14 (20)"`: the
    /// first counts, and a rule compares the other. The bytes of an octet string are written in hexadecimal, `"0A1B"`. In a
    /// range of entries it can count with them: `"{+0x300}"`.
    pub default: Option<Literal>,
    /// The least value.
    pub min: Option<Literal>,
    /// The greatest value.
    pub max: Option<Literal>,
    /// What single values mean, by value; or one of `[enumerations]`, `"inputs"`, that has it.
    pub values: Option<RawValues>,
    /// The EtherCAT states in which it may be written; any in which there is a mailbox if absent.
    pub written: Option<WriteWindow>,
    /// Whether a tool saves it, to write it to a device that takes this one's place.
    pub backup: Option<bool>,
    /// Whether it is one of the settings of an application.
    pub setting: Option<bool>,
    /// When a new value takes effect: `"at-once"`, `"disabled"`, `"safe-op"` or `"restart"`.
    pub effective: Option<Effective>,
    /// Whether the device keeps it when it is switched off: `"at-once"`, `"on-request"` or `"never"`.
    pub stored: Option<Stored>,
    /// What it is for.
    pub about: Option<String>,
    /// What else is to be said of it here.
    pub note: Option<String>,
    /// False if it exists for compatibility only and does nothing.
    pub functional: Option<bool>,
    /// What writing it sets off.
    pub trigger: Option<RawTrigger>,
    /// The vendor's own name of the parameter behind it, as `"A515"` or `"PTBASE"`. That of an object with entries can number
    /// them: with `"H02-{-1:02}"`, entry 6 is H02-05.
    pub parameter: Option<String>,
    /// What the vendor's tools are told of it: names and values that an ESI hands on as they are.
    #[serde(default)]
    pub properties: Vec<Property>,
}

/// What writing a value sets off. Objects of axes that it names are those of the same axis, or of each axis if what is
/// written is there once.
#[derive(Debug, Default, Clone, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawTrigger {
    /// The value to write.
    pub value: Literal,
    /// What it does.
    pub action: String,
    /// The mode of operation that must be active.
    pub mode: Option<i16>,
    /// The objects that it takes its data from.
    #[serde(default)]
    pub uses: Vec<String>,
    /// The objects that it changes.
    #[serde(default)]
    pub updates: Vec<String>,
}
