//! How sure a statement is: `source`, `assumed`, `[[remarks]]`, `[[errata]]`.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::de::{self, Deserializer, MapAccess, Visitor};

/// What every table may say of itself.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawFacts {
    /// Where its facts are from: a place in the first of `[documents]`, or `"<document>: <place>"`.
    pub source: Option<String>,
    /// Why what it says is taken to be so although no source says it: one reason for the whole table, or
    /// one for each key that is assumed.
    pub assumed: Option<RawAssumed>,
}

/// One reason for a table, or one for each of some keys.
#[derive(Debug)]
pub enum RawAssumed {
    /// The whole table is assumed.
    All(String),
    /// These keys are.
    Keys(BTreeMap<String, String>),
}

impl<'de> Deserialize<'de> for RawAssumed {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Assumed;
        impl<'de> Visitor<'de> for Assumed {
            type Value = RawAssumed;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a reason, or a table from keys to reasons")
            }

            fn visit_str<E: de::Error>(self, reason: &str) -> Result<RawAssumed, E> {
                Ok(RawAssumed::All(reason.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<RawAssumed, A::Error> {
                BTreeMap::deserialize(de::value::MapAccessDeserializer::new(map)).map(RawAssumed::Keys)
            }
        }
        deserializer.deserialize_any(Assumed)
    }
}

/// `[[errata]]`: the answer to one finding of one rule.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawErratum {
    /// The rule that found it.
    pub rule: String,
    /// What it was found at, as the message names it.
    pub at: String,
    /// What the manual says.
    pub says: String,
    /// What is so.
    pub holds: String,
    /// How one knows.
    pub why: String,
}

/// `[[remarks]]`: a weakness of the sources that no rule can see.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawRemark {
    /// What it is about, as an erratum would name it.
    pub at: String,
    /// Whether the sources contradict each other, say nothing, or can be read in two ways.
    pub kind: RawRemarkKind,
    /// What there is to know.
    pub text: String,
}

/// What is weak.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawRemarkKind {
    /// Two places disagree.
    Contradiction,
    /// No place says it.
    Silence,
    /// A place can be read in two ways, or is hard to believe.
    #[default]
    Doubt,
}
