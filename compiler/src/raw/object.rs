//! The object dictionary: `[objects.<index>]` and its entries.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::{Literal, RawField};

/// `[objects.<index>]`: an object of the dictionary. The keys from `name` on say what its value is; the tables
/// in `entries` have them, too.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawObject {
    /// The word by which the rest of the description refers to it; made from the name if absent.
    pub id: Option<String>,
    /// `"var"`, `"array"` or `"record"`; what the entries look like if absent.
    pub kind: Option<RawKind>,
    /// The entries by subindex, `"1"`, or by a range of them, `"1..=16"`, in whose `name` and `parameter` `{}`
    /// or `{+8}` is a number; none for a single value.
    #[serde(default)]
    pub entries: BTreeMap<String, Ignored>,
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

/// What an object is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawKind {
    /// One value at subindex 0.
    Var,
    /// Values of one type from subindex 1 on.
    Array,
    /// Values of different types from subindex 1 on.
    Record,
}

/// A value that an index and a subindex name.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawEntry {
    /// Its name.
    pub name: Option<String>,
    /// Its data type: `BOOL`, `INT8` to `INT64`, `UINT8` to `UINT64`, `REAL32`, `REAL64`, `BYTE`, `WORD`,
    /// `DWORD`, `BIT1` to `BIT8`, `STRING` or `STRING(n)`.
    pub r#type: Option<String>,
    /// `"ro"`, `"wo"`, `"rw"` or `"const"`.
    pub access: Option<RawAccess>,
    /// The process data it can be mapped to: `"rx"`, `"tx"`, `"rx-tx"` or `"none"`.
    pub pdo: Option<RawMappable>,
    /// Whether the profile demands it: `"mandatory"`, `"optional"` or `"conditional"`.
    pub category: Option<RawCategory>,
    /// The unit of its value, one of `[units]`.
    pub unit: Option<String>,
    /// The value after start-up. A number can be written as a manual prints it in two columns, `"0x14 (20)"`: the
    /// first counts, and a rule compares the other.
    pub default: Option<Literal>,
    /// The least value.
    pub min: Option<Literal>,
    /// The greatest value.
    pub max: Option<Literal>,
    /// What single values mean, by value.
    #[serde(default)]
    pub values: BTreeMap<String, RawField>,
    /// The state change during which it may be written, as `"PS"`; in any state if absent.
    pub written: Option<String>,
    /// What it is for.
    pub about: Option<String>,
    /// What else is to be said of it here.
    pub note: Option<String>,
    /// False if it exists for compatibility only and does nothing.
    pub functional: Option<bool>,
    /// What writing it sets off.
    pub trigger: Option<RawTrigger>,
    /// The vendor's own name of the parameter behind it, as `"A515"` or `"PTBASE"`.
    pub parameter: Option<String>,
}

/// What writing a value sets off.
#[derive(Debug, Default, Deserialize)]
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

/// Who may read and write a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawAccess {
    /// Read only.
    Ro,
    /// Write only.
    Wo,
    /// Read and write.
    Rw,
    /// Read only and never different.
    Const,
}

/// The process data a value can be mapped to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawMappable {
    /// None.
    None,
    /// What the master sends.
    Rx,
    /// What the device sends.
    Tx,
    /// Both.
    RxTx,
}

/// Whether a profile demands an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawCategory {
    /// Always.
    Mandatory,
    /// Never.
    Optional,
    /// If something else is there.
    Conditional,
}
