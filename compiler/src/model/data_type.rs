//! The types of values on the wire.

use std::fmt;
use std::str::FromStr;

use super::compare::value;
use super::plain;

plain! {
    /// A basic data type of CiA 301, as ETG.1020 lists them.
    #[derive(Copy, Eq)]
    #[cfg_attr(feature = "json", serde(into = "String"))]
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub enum DataType {
        /// One bit in a byte of its own outside process data.
        Bool,
        /// A signed number of 8 to 64 bits.
        Int(u8),
        /// An unsigned number of 8 to 64 bits.
        Uint(u8),
        /// An IEEE 754 number of 32 bits.
        Real32,
        /// An IEEE 754 number of 64 bits.
        Real64,
        /// 8, 16 or 32 bits without a meaning as a number: BYTE, WORD, DWORD.
        Bitstring(u8),
        /// 1 to 8 bits.
        Bits(u8),
        /// Text of so many bytes.
        Text(u16),
    }
}

value! { DataType }

impl DataType {
    /// The width in bits.
    pub fn bits(self) -> u32 {
        match self {
            Self::Bool => 1,
            Self::Int(bits) | Self::Uint(bits) | Self::Bitstring(bits) | Self::Bits(bits) => bits.into(),
            Self::Real32 => 32,
            Self::Real64 => 64,
            Self::Text(bytes) => u32::from(bytes) * 8,
        }
    }

    /// The width in whole bytes, as an SDO carries it.
    pub fn bytes(self) -> u32 {
        self.bits().div_ceil(8)
    }

    /// The least and the greatest whole number, if it holds whole numbers.
    pub fn range(self) -> Option<(i128, i128)> {
        match self {
            Self::Bool => Some((0, 1)),
            Self::Int(bits) => Some((-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1)),
            Self::Uint(bits) | Self::Bitstring(bits) | Self::Bits(bits) => Some((0, (1_i128 << bits) - 1)),
            Self::Real32 | Self::Real64 | Self::Text(_) => None,
        }
    }
}

impl fmt::Display for DataType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool => f.write_str("BOOL"),
            Self::Int(bits) => write!(f, "INT{bits}"),
            Self::Uint(bits) => write!(f, "UINT{bits}"),
            Self::Real32 => f.write_str("REAL32"),
            Self::Real64 => f.write_str("REAL64"),
            Self::Bitstring(8) => f.write_str("BYTE"),
            Self::Bitstring(16) => f.write_str("WORD"),
            Self::Bitstring(_) => f.write_str("DWORD"),
            Self::Bits(bits) => write!(f, "BIT{bits}"),
            Self::Text(bytes) => write!(f, "STRING({bytes})"),
        }
    }
}

impl From<DataType> for String {
    fn from(data_type: DataType) -> Self {
        data_type.to_string()
    }
}

impl FromStr for DataType {
    type Err = ();

    /// Reads a type as descriptions write it; `STRING` without a length has length 0, to be filled in
    /// from the default.
    fn from_str(text: &str) -> Result<Self, ()> {
        let number = |prefix: &str| text.strip_prefix(prefix).and_then(|rest| rest.parse::<u8>().ok());
        let whole = |bits: u8| (8..=64).contains(&bits) && bits.is_multiple_of(8);
        match text {
            "BOOL" => Ok(Self::Bool),
            "REAL32" => Ok(Self::Real32),
            "REAL64" => Ok(Self::Real64),
            "BYTE" => Ok(Self::Bitstring(8)),
            "WORD" => Ok(Self::Bitstring(16)),
            "DWORD" => Ok(Self::Bitstring(32)),
            "STRING" => Ok(Self::Text(0)),
            _ => {
                let length = text.strip_prefix("STRING(").and_then(|rest| rest.strip_suffix(')'));
                if let Some(bytes) = length.and_then(|length| length.parse().ok()) {
                    return Ok(Self::Text(bytes));
                }
                let int = number("INT").filter(|bits| whole(*bits)).map(Self::Int);
                let uint = number("UINT").filter(|bits| whole(*bits)).map(Self::Uint);
                let bits = number("BIT").filter(|bits| (1..=8).contains(bits)).map(Self::Bits);
                int.or(uint).or(bits).ok_or(())
            }
        }
    }
}
