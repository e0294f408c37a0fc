//! Values as descriptions have them, of whatever type.

use std::fmt;

use serde::Deserialize;
use serde::de::{self, Deserializer, MapAccess, SeqAccess, Visitor};

use super::compare::value;

/// A value, or keys with values.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
#[cfg_attr(feature = "json", serde(untagged))]
pub enum Said {
    /// `true` or `false`.
    Boolean(bool),
    /// A whole number.
    Integer(i64),
    /// A number with a fraction.
    Real(f64),
    /// Text.
    Text(String),
    /// A list.
    List(Vec<Said>),
    /// Keys with values.
    #[cfg_attr(feature = "json", serde(serialize_with = "as_map"))]
    Keys(Vec<(String, Said)>),
}

#[cfg(feature = "json")]
fn as_map<S: serde::Serializer>(keys: &[(String, Said)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(keys.iter().map(|(key, value)| (key, value)))
}

value! { Said }

impl Default for Said {
    fn default() -> Self {
        Self::Keys(Vec::new())
    }
}

impl<'de> Deserialize<'de> for Said {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AnyValue)
    }
}

struct AnyValue;

impl<'de> Visitor<'de> for AnyValue {
    type Value = Said;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value, or a table from keys to values")
    }

    fn visit_bool<E: de::Error>(self, value: bool) -> Result<Said, E> {
        Ok(Said::Boolean(value))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Said, E> {
        Ok(Said::Integer(value))
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Said, E> {
        i64::try_from(value)
            .map(Said::Integer)
            .map_err(|_| E::custom("a number of up to 63 bits is expected"))
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Said, E> {
        Ok(Said::Real(value))
    }

    fn visit_str<E: de::Error>(self, value: &str) -> Result<Said, E> {
        Ok(Said::Text(value.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Said, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = list.next_element()? {
            items.push(item);
        }
        Ok(Said::List(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Said, A::Error> {
        let mut keys = Vec::new();
        while let Some(entry) = map.next_entry()? {
            keys.push(entry);
        }
        Ok(Said::Keys(keys))
    }
}

impl fmt::Display for Said {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |f: &mut fmt::Formatter<'_>, parts: Vec<String>| f.write_str(&parts.join(", "));
        match self {
            Self::Boolean(value) => write!(f, "{value}"),
            // What is large is rather an index, a code or a row of bits.
            Self::Integer(value) if *value > 0xFF => write!(f, "0x{value:X} ({value})"),
            Self::Integer(value) => write!(f, "{value}"),
            Self::Real(value) => write!(f, "{value}"),
            Self::Text(text) => f.write_str(text),
            Self::List(items) => list(f, items.iter().map(ToString::to_string).collect()),
            Self::Keys(keys) => list(f, keys.iter().map(|(key, value)| format!("{key} = {value}")).collect()),
        }
    }
}
