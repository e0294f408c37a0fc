//! The types of values on the wire.

use std::fmt;

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
        /// So many bytes without a meaning of their own.
        Octets(u16),
        /// Text of so many units of 16 bits.
        Unicode(u16),
        /// So many numbers of one type, which travel as one value.
        Array(Item, u16),
    }

    /// The numbers that arrays are made of.
    #[derive(Copy, Eq)]
    pub enum Item {
        /// 8 bits with a sign.
        Int8,
        /// 16 bits with a sign.
        Int16,
        /// 32 bits with a sign.
        Int32,
        /// 32 bits without a sign.
        Uint32,
    }
}

impl Item {
    /// All of them.
    pub(crate) const ALL: [Self; 4] = [Self::Int8, Self::Int16, Self::Int32, Self::Uint32];

    /// The type of each number.
    pub fn data_type(self) -> DataType {
        match self {
            Self::Int8 => DataType::Int(8),
            Self::Int16 => DataType::Int(16),
            Self::Int32 => DataType::Int(32),
            Self::Uint32 => DataType::Uint(32),
        }
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
            Self::Text(bytes) | Self::Octets(bytes) => u32::from(bytes) * 8,
            Self::Unicode(units) => u32::from(units) * 16,
            Self::Array(item, count) => u32::from(count) * item.data_type().bits(),
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
            Self::Real32 | Self::Real64 | Self::Text(_) | Self::Octets(_) | Self::Unicode(_) => None,
            Self::Array(..) => None,
        }
    }

    /// Its number in the dictionary: CiA 301, data type definitions, and ETG.1020, base data types.
    pub fn code(self) -> u16 {
        match self {
            Self::Bool => 0x01,
            Self::Int(8) => 0x02,
            Self::Int(16) => 0x03,
            Self::Int(32) => 0x04,
            Self::Uint(8) => 0x05,
            Self::Uint(16) => 0x06,
            Self::Uint(32) => 0x07,
            Self::Real32 => 0x08,
            Self::Text(_) => 0x09,
            Self::Octets(_) => 0x0A,
            Self::Unicode(_) => 0x0B,
            Self::Real64 => 0x11,
            Self::Int(24) => 0x10,
            // 40 to 64 bits follow one another, and so do those without a sign; 0x17 is a time
            Self::Int(bits) => 0x0D + u16::from(bits / 8),
            Self::Uint(24) => 0x16,
            Self::Uint(bits) => 0x13 + u16::from(bits / 8),
            Self::Bitstring(8) => 0x1E,
            Self::Bitstring(16) => 0x1F,
            Self::Bitstring(_) => 0x20,
            Self::Bits(bits) => 0x2F + u16::from(bits),
            Self::Array(Item::Int16, _) => 0x0260,
            Self::Array(Item::Int8, _) => 0x0261,
            Self::Array(Item::Int32, _) => 0x0262,
            Self::Array(Item::Uint32, _) => 0x0263,
        }
    }

    /// The type that says of a value no more than how wide it is, if there is one.
    pub fn of_width(bits: u32) -> Option<Self> {
        let narrow = u8::try_from(bits).ok()?;
        match narrow {
            8 | 16 | 32 => Some(Self::Bitstring(narrow)),
            1..8 => Some(Self::Bits(narrow)),
            24 | 40 | 48 | 56 | 64 => Some(Self::Uint(narrow)),
            _ => None,
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
            Self::Octets(bytes) => write!(f, "OCTET_STRING({bytes})"),
            Self::Unicode(units) => write!(f, "UNICODE_STRING({units})"),
            Self::Array(item, count) => write!(f, "ARRAY_OF_{}({count})", item.data_type()),
        }
    }
}

impl From<DataType> for String {
    fn from(data_type: DataType) -> Self {
        data_type.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::DataType;

    /// Numbers of CiA 301 and ETG.1020.
    #[test]
    fn types_have_their_numbers() {
        let numbers = [
            ("BOOL", 0x01),
            ("INT8", 0x02),
            ("INT16", 0x03),
            ("INT24", 0x10),
            ("INT32", 0x04),
            ("INT40", 0x12),
            ("INT48", 0x13),
            ("INT56", 0x14),
            ("INT64", 0x15),
            ("UINT8", 0x05),
            ("UINT16", 0x06),
            ("UINT24", 0x16),
            ("UINT32", 0x07),
            ("UINT40", 0x18),
            ("UINT48", 0x19),
            ("UINT56", 0x1A),
            ("UINT64", 0x1B),
            ("REAL32", 0x08),
            ("REAL64", 0x11),
            ("STRING(4)", 0x09),
            ("OCTET_STRING(4)", 0x0A),
            ("UNICODE_STRING(4)", 0x0B),
            ("ARRAY_OF_INT16(4)", 0x0260),
            ("ARRAY_OF_INT8(4)", 0x0261),
            ("ARRAY_OF_INT32(4)", 0x0262),
            ("ARRAY_OF_UINT32(4)", 0x0263),
            ("BYTE", 0x1E),
            ("WORD", 0x1F),
            ("DWORD", 0x20),
            ("BIT1", 0x30),
            ("BIT8", 0x37),
        ];
        for (name, number) in numbers {
            assert_eq!(name.parse::<DataType>().unwrap().code(), number, "{name}");
        }
    }
}
