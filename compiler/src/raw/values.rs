//! What single values mean, there or by the name of an enumeration.

use std::fmt;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error, MapAccess, Visitor};

use crate::model::Meanings;

/// What single values mean.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(untagged, inline))]
pub enum RawValues {
    /// As an enumeration says it.
    Shared(String),
    /// As it stands there.
    Own(Meanings),
}

impl<'de> Deserialize<'de> for RawValues {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = RawValues;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a table, or the name of an enumeration")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<RawValues, E> {
                Ok(RawValues::Shared(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<RawValues, A::Error> {
                Meanings::deserialize(MapAccessDeserializer::new(map)).map(RawValues::Own)
            }
        }
        deserializer.deserialize_any(Either)
    }
}
