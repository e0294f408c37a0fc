//! How sure a statement is: `source`, `assumed`.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde::de::{self, Deserializer, MapAccess, Visitor};

/// What every table may say of itself.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawFacts {
    /// Where its facts are from: a place in the first of `[documents]`, or `"<document>: <place>"`; `false` if not even
    /// the `source` of the file holds for it.
    pub source: Option<RawSource>,
    /// Why what it says is taken to be so although no source says it: one reason for the whole table, or
    /// one for each key that is assumed.
    pub assumed: Option<RawAssumed>,
}

/// Where facts are from, or that this is not known.
#[derive(Debug)]
pub enum RawSource {
    /// A place in a document.
    Place(String),
    /// None.
    None,
}

/// One reason for a table, or one for each of some keys.
#[derive(Debug)]
pub enum RawAssumed {
    /// The whole table is assumed.
    All(String),
    /// These keys are.
    Keys(BTreeMap<String, String>),
}

impl<'de> Deserialize<'de> for RawSource {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Place;
        impl Visitor<'_> for Place {
            type Value = RawSource;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a place in a document, or `false`")
            }

            fn visit_str<E: de::Error>(self, place: &str) -> Result<RawSource, E> {
                Ok(RawSource::Place(place.to_owned()))
            }

            fn visit_bool<E: de::Error>(self, known: bool) -> Result<RawSource, E> {
                if known {
                    Err(E::custom("expected a place in a document, or `false`"))
                } else {
                    Ok(RawSource::None)
                }
            }
        }
        deserializer.deserialize_any(Place)
    }
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
