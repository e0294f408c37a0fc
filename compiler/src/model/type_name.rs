//! The names of data types: as descriptions write them, and as they are called elsewhere.

use std::str::FromStr;

use super::{DataType, Item};

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
        "STRING" if length > 0 => Some(DataType::Text(length)),
        "OCTET_STRING" if length > 0 => Some(DataType::Octets(length)),
        "UNICODE_STRING" if (1..=0x7FFF).contains(&length) => Some(DataType::Unicode(length)),
        _ if (1..=0x3FFF).contains(&length) => {
            let of = name.strip_prefix("ARRAY_OF_")?;
            let item = Item::ALL.into_iter().find(|item| item.data_type().to_string() == of)?;
            Some(DataType::Array(item, length))
        }
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

/// Bytes, units of text or numbers as ESI has them: `ARRAY [0..7] OF BYTE`.
fn array(text: &str) -> Option<DataType> {
    let (bounds, of) = text.strip_prefix("ARRAY")?.trim().strip_prefix('[')?.split_once(']')?;
    let last: u16 = bounds.split_once("..")?.1.trim().parse().ok()?;
    let length = last.checked_add(1)?;
    match of.trim().strip_prefix("OF")?.trim() {
        "BYTE" | "USINT" => Some(DataType::Octets(length)),
        "UINT" | "WORD" => Some(DataType::Unicode(length)).filter(|_| length <= 0x7FFF),
        of => {
            let plain = DataType::named_elsewhere(of)?;
            let item = Item::ALL.into_iter().find(|item| item.data_type() == plain)?;
            Some(DataType::Array(item, length)).filter(|_| length <= 0x3FFF)
        }
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
            ("ARRAY [0..3] OF DINT", "ARRAY_OF_INT32(4)"),
            ("ARRAY [0..7] OF INT", "ARRAY_OF_INT16(8)"),
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
        for nothing in ["", "INTEGER7", "ARRAY [0..7] OF REAL", "STRING(-1)", "ARRAY [0..65535] OF BYTE"] {
            assert_eq!(DataType::named_elsewhere(nothing), None, "{nothing}");
        }
    }

    #[test]
    fn types_are_read_as_they_are_written() {
        let same = ["OCTET_STRING(8)", "UNICODE_STRING(20)", "STRING(1)", "BIT5", "DWORD", "UINT56"];
        for text in same.into_iter().chain(["ARRAY_OF_INT8(6)", "ARRAY_OF_UINT32(2)"]) {
            assert_eq!(text.parse::<DataType>().unwrap().to_string(), text);
        }
        let empty =
            ["STRING(0)", "OCTET_STRING(0)", "UNICODE_STRING(0)", "ARRAY_OF_INT16(0)", "BIT0", "INT0"];
        let others = ["ARRAY_OF_INT16", "ARRAY_OF_UINT16(2)", "ARRAY_OF_INT16(40000)", "STRING(65536)"];
        for text in empty.into_iter().chain(others) {
            assert_eq!(text.parse::<DataType>(), Err(()), "{text}");
        }
        let bits = |text: &str| text.parse::<DataType>().unwrap().bits();
        assert_eq!((bits("OCTET_STRING(8)"), bits("UNICODE_STRING(8)")), (64, 128));
        assert_eq!((bits("ARRAY_OF_INT8(6)"), bits("ARRAY_OF_INT32(6)")), (48, 192));
    }
}
