//! Values of objects.

use std::fmt;

use serde::{Deserialize, Deserializer};

use super::compare::value;
use super::{DataType, Hex, Literal, plain};

plain! {
    /// A value that fits the type it was resolved for.
    #[cfg_attr(feature = "json", serde(untagged))]
    #[cfg_attr(feature = "schema", schemars(inline))]
    pub enum Value {
        /// `true` or `false`.
        Boolean(bool),
        /// A whole number.
        Integer(i64),
        /// A whole number beyond the signed 64 bits.
        Unsigned(u64),
        /// A number with a fraction.
        Real(f64),
        /// Text; of an octet string its bytes in hexadecimal.
        Text(String),
    }
}

value! { Value }

impl Value {
    /// The value as it travels, in exactly the bytes of its type.
    pub fn little_endian(&self, data_type: DataType) -> Vec<u8> {
        let mut bytes = match self {
            Self::Boolean(value) => vec![u8::from(*value)],
            Self::Integer(value) => value.to_le_bytes().to_vec(),
            Self::Unsigned(value) => value.to_le_bytes().to_vec(),
            Self::Real(value) if data_type == DataType::Real32 => (*value as f32).to_le_bytes().to_vec(),
            Self::Real(value) => value.to_le_bytes().to_vec(),
            Self::Text(text) if matches!(data_type, DataType::Unicode(_)) => {
                text.encode_utf16().flat_map(u16::to_le_bytes).collect()
            }
            Self::Text(text) if matches!(data_type, DataType::Octets(_)) => {
                Hex::parse(text).unwrap_or_default().0
            }
            Self::Text(text) => text.as_bytes().to_vec(),
        };
        bytes.resize(usize::try_from(data_type.bytes()).unwrap_or(0), 0);
        bytes
    }

    /// The number it is, if it is one.
    pub fn real(&self) -> Option<f64> {
        match self {
            Self::Real(value) => Some(*value),
            other => other.integer().map(|value| value as f64),
        }
    }

    /// The whole number it is, if it is one.
    pub fn integer(&self) -> Option<i128> {
        match self {
            Self::Boolean(value) => Some(i128::from(*value)),
            Self::Integer(value) => Some(i128::from(*value)),
            Self::Unsigned(value) => Some(i128::from(*value)),
            Self::Real(_) | Self::Text(_) => None,
        }
    }
}

/// As it is written, where there is no type to fit it to.
impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Literal::deserialize(deserializer).map(|literal| Self::from(&literal))
    }
}

impl From<&Literal> for Value {
    fn from(literal: &Literal) -> Self {
        match literal {
            Literal::Boolean(value) => Self::Boolean(*value),
            Literal::Float(value) => Self::Real(*value),
            Literal::Text(text) => Self::Text(text.clone()),
            Literal::Integer(value) => {
                i64::try_from(*value).map_or_else(|_| Self::Text(value.to_string()), Self::Integer)
            }
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Boolean(value) => write!(f, "{value}"),
            Self::Integer(value) => write!(f, "{value}"),
            Self::Unsigned(value) => write!(f, "{value}"),
            Self::Real(value) => write!(f, "{value}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}
