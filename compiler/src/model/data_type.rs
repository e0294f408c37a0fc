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
        /// So many bytes without a meaning of their own.
        Octets(u16),
        /// Text of so many units of 16 bits.
        Unicode(u16),
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
                if let Some(sized) = sized(text) {
                    return Ok(sized);
                }
                let int = number("INT").filter(|bits| whole(*bits)).map(Self::Int);
                let uint = number("UINT").filter(|bits| whole(*bits)).map(Self::Uint);
                let bits = number("BIT").filter(|bits| (1..=8).contains(bits)).map(Self::Bits);
                int.or(uint).or(bits).ok_or(())
            }
        }
    }
}

/// A type of a length: `STRING(8)`.
fn sized(text: &str) -> Option<DataType> {
    let (name, length) = text.strip_suffix(')')?.split_once('(')?;
    let length = length.parse::<u16>().ok()?;
    match name {
        "STRING" => Some(DataType::Text(length)),
        "OCTET_STRING" if length > 0 => Some(DataType::Octets(length)),
        "UNICODE_STRING" if (1..=0x7FFF).contains(&length) => Some(DataType::Unicode(length)),
        _ => None,
    }
}

impl DataType {
    /// The type that ESI, IEC 61131-3 or CiA 301 call so, where a description calls it otherwise.
    pub(crate) fn named_elsewhere(text: &str) -> Option<Self> {
        let text = text.trim().to_ascii_uppercase();
        let bits = |prefix: &str| text.strip_prefix(prefix).and_then(|bits| bits.parse::<u8>().ok());
        let whole = |bits: &u8| (8..=64).contains(bits) && bits.is_multiple_of(8);
        let plain = match text.as_str() {
            "BOOLEAN" | "BIT" => Some(Self::Bool),
            "F32" | "FLOAT" | "FLOAT32" => Some(Self::Real32),
            "F64" | "DOUBLE" | "FLOAT64" => Some(Self::Real64),
            "SINT" => Some(Self::Int(8)),
            "INT" => Some(Self::Int(16)),
            "DINT" => Some(Self::Int(32)),
            "LINT" => Some(Self::Int(64)),
            "USINT" => Some(Self::Uint(8)),
            "UINT" => Some(Self::Uint(16)),
            "UDINT" => Some(Self::Uint(32)),
            "ULINT" => Some(Self::Uint(64)),
            "REAL" => Some(Self::Real32),
            "LREAL" => Some(Self::Real64),
            "BITARR8" => Some(Self::Bitstring(8)),
            "BITARR16" => Some(Self::Bitstring(16)),
            "BITARR32" => Some(Self::Bitstring(32)),
            _ => None,
        };
        plain
            .or_else(|| bits("INTEGER").filter(whole).map(Self::Int))
            .or_else(|| bits("UNSIGNED").filter(whole).map(Self::Uint))
            .or_else(|| bits("I").filter(whole).map(Self::Int))
            .or_else(|| bits("U").filter(whole).map(Self::Uint))
            .or_else(|| text.strip_suffix("_T")?.parse().ok())
            .or_else(|| sized(text.strip_prefix("VISIBLE_")?))
            .or_else(|| array(&text))
            .or_else(|| text.parse().ok())
    }
}

/// Bytes or units of text as ESI has them: `ARRAY [0..7] OF BYTE`.
fn array(text: &str) -> Option<DataType> {
    let (bounds, of) = text.strip_prefix("ARRAY")?.trim().strip_prefix('[')?.split_once(']')?;
    let last: u16 = bounds.split_once("..")?.1.trim().parse().ok()?;
    let length = last.checked_add(1)?;
    match of.trim().strip_prefix("OF")?.trim() {
        "BYTE" | "USINT" => Some(DataType::Octets(length)),
        "UINT" | "WORD" => Some(DataType::Unicode(length)).filter(|_| length <= 0x7FFF),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::DataType;

    /// Names of ETG.1020 and IEC 61131-3 with what a description writes.
    #[test]
    fn names_of_other_places_are_known() {
        let pairs = [
            ("DINT", "INT32"),
            ("ULINT", "UINT64"),
            ("INTEGER24", "INT24"),
            ("Unsigned8", "UINT8"),
            ("BOOLEAN", "BOOL"),
            ("LREAL", "REAL64"),
            ("BITARR16", "WORD"),
            ("VISIBLE_STRING(20)", "STRING(20)"),
            ("ARRAY [0..7] OF BYTE", "OCTET_STRING(8)"),
            ("int16", "INT16"),
            ("u16", "UINT16"),
            ("i32", "INT32"),
            ("f32", "REAL32"),
            ("uint8_t", "UINT8"),
            ("double", "REAL64"),
        ];
        for (elsewhere, here) in pairs {
            let found = DataType::named_elsewhere(elsewhere).map(|it| it.to_string());
            assert_eq!(found.as_deref(), Some(here), "{elsewhere}");
        }
        for nothing in ["", "INTEGER7", "ARRAY [0..7] OF INT", "STRING(-1)", "ARRAY [0..65535] OF BYTE"] {
            assert_eq!(DataType::named_elsewhere(nothing), None, "{nothing}");
        }
    }

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

    #[test]
    fn types_are_read_as_they_are_written() {
        for text in ["OCTET_STRING(8)", "UNICODE_STRING(20)", "STRING(3)", "BIT5", "DWORD", "UINT56"] {
            assert_eq!(text.parse::<DataType>().unwrap().to_string(), text);
        }
        let bits = |text: &str| text.parse::<DataType>().unwrap().bits();
        assert_eq!((bits("OCTET_STRING(8)"), bits("UNICODE_STRING(8)")), (64, 128));
    }
}
