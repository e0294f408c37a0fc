//! Values of objects.

use std::fmt;

use super::{DataType, model};

model! {
    /// A value that fits the type it was resolved for.
    #[cfg_attr(feature = "json", serde(untagged))]
    pub enum Value {
        /// `true` or `false`.
        Boolean(bool),
        /// A whole number.
        Integer(i64),
        /// A whole number beyond the signed 64 bits.
        Unsigned(u64),
        /// A number with a fraction.
        Real(f64),
        /// Text.
        Text(String),
    }
}

impl Value {
    /// The value as it travels, in exactly the bytes of its type.
    pub fn little_endian(&self, data_type: DataType) -> Vec<u8> {
        let mut bytes = match self {
            Self::Boolean(value) => vec![u8::from(*value)],
            Self::Integer(value) => value.to_le_bytes().to_vec(),
            Self::Unsigned(value) => value.to_le_bytes().to_vec(),
            Self::Real(value) if data_type == DataType::Real32 => (*value as f32).to_le_bytes().to_vec(),
            Self::Real(value) => value.to_le_bytes().to_vec(),
            Self::Text(text) => text.as_bytes().to_vec(),
        };
        bytes.resize(usize::try_from(data_type.bytes()).unwrap_or(0), 0);
        bytes
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
