//! The types of ESI files in the words of descriptions.

use crate::model::DataType;

/// The type of a name and a width, and whether it is another than the name says; none if descriptions have none for it.
///
/// What an object or a member says of its width counts more than what its type is called, since it is what a master
/// goes by.
pub(super) fn data_type(name: &str, bits: Option<u32>) -> Option<(DataType, bool)> {
    let named = named(name);
    let bits = bits.filter(|bits| *bits > 0);
    match (named, bits) {
        (Some(DataType::Text(_)), Some(bits)) => {
            let bytes = u16::try_from(bits / 8).ok().filter(|bytes| *bytes > 0)?;
            let whole = DataType::Text(bytes);
            Some((whole, named != Some(whole) && named != Some(DataType::Text(0))))
        }
        (Some(DataType::Octets(_)), Some(bits)) => {
            let bytes = u16::try_from(bits / 8).ok().filter(|bytes| *bytes > 0 && bits.is_multiple_of(8))?;
            Some((DataType::Octets(bytes), named != Some(DataType::Octets(bytes))))
        }
        (Some(DataType::Octets(0)), None) => None,
        (Some(DataType::Text(0)), None) => Some((DataType::Text(1), true)),
        (Some(named), None) => Some((named, false)),
        (Some(named), Some(bits)) if named.bits() == bits => Some((named, is_stand_in(name))),
        (Some(DataType::Int(_)), Some(bits)) if whole(bits) => {
            Some((DataType::Int(u8::try_from(bits).ok()?), true))
        }
        // An enumeration of some bits is made of bytes by its name.
        (Some(DataType::Uint(8)), Some(bits)) if bits < 8 => {
            Some((DataType::Bits(u8::try_from(bits).ok()?), false))
        }
        (None, Some(_)) if is_composite(name) => None,
        (_, Some(bits)) => unsigned(bits).map(|it| (it, true)),
        (None, None) => None,
    }
}

fn whole(bits: u32) -> bool {
    (8..=64).contains(&bits) && bits.is_multiple_of(8)
}

fn unsigned(bits: u32) -> Option<DataType> {
    let bits = u8::try_from(bits).ok()?;
    match bits {
        1..=7 => Some(DataType::Bits(bits)),
        _ => whole(bits.into()).then_some(DataType::Uint(bits)),
    }
}

/// A type of several values that stands where one is meant: bytes without a meaning of their own.
fn is_composite(name: &str) -> bool {
    let name = name.trim().to_ascii_uppercase();
    name.starts_with("ARRAY") || name.starts_with("OCTET")
}

/// Whether another type stands for the one of this name.
pub(super) fn is_stand_in(name: &str) -> bool {
    name.trim().to_ascii_uppercase().starts_with("BITARR")
}

/// `ARRAY [0..15] OF BYTE` and `OCTET_STRING(16)`.
fn octets(name: &str) -> Option<DataType> {
    let array = name.strip_prefix("ARRAY").and_then(|rest| {
        let (range, kind) = rest.trim().strip_prefix('[')?.split_once(']')?;
        let (first, last) = range.split_once("..")?;
        let (first, last): (i32, i32) = (first.trim().parse().ok()?, last.trim().parse().ok()?);
        let is_bytes = kind.split_whitespace().eq(["OF", "BYTE"]);
        u16::try_from(last.checked_sub(first)?.checked_add(1)?).ok().filter(|_| is_bytes)
    });
    let string = || name.strip_prefix("OCTET_STRING(")?.strip_suffix(')')?.trim().parse().ok();
    array.or_else(string).map(DataType::Octets)
}

/// The name of a type that CiA 301 or IEC 61131-3 spells otherwise than ETG.1020: `INTEGER16`, `UNSIGNED8`, `STRING[8]`.
fn standard(name: &str) -> String {
    if let Some(bits) = name.strip_prefix("INTEGER") {
        return format!("INT{bits}");
    }
    if let Some(bits) = name.strip_prefix("UNSIGNED") {
        return format!("UINT{bits}");
    }
    match name.split_once('[') {
        Some((kind, length)) if kind.ends_with("STRING") => format!("{kind}({}", length.replace(']', ")")),
        _ => name.to_owned(),
    }
}

fn named(name: &str) -> Option<DataType> {
    let name = standard(&name.trim().to_ascii_uppercase());
    let number = |prefix: &str| name.strip_prefix(prefix).and_then(|rest| rest.parse::<u8>().ok());
    let basic = match name.as_str() {
        "BOOL" | "BOOLEAN" | "BIT" => Some(DataType::Bool),
        "SINT" => Some(DataType::Int(8)),
        "INT" => Some(DataType::Int(16)),
        "DINT" => Some(DataType::Int(32)),
        "LINT" => Some(DataType::Int(64)),
        "USINT" => Some(DataType::Uint(8)),
        "UINT" => Some(DataType::Uint(16)),
        "UDINT" => Some(DataType::Uint(32)),
        "ULINT" => Some(DataType::Uint(64)),
        "REAL" | "REAL32" => Some(DataType::Real32),
        "LREAL" | "REAL64" => Some(DataType::Real64),
        "BYTE" | "BITARR8" => Some(DataType::Bitstring(8)),
        "WORD" | "BITARR16" => Some(DataType::Bitstring(16)),
        "DWORD" | "BITARR32" => Some(DataType::Bitstring(32)),
        "STRING" | "VISIBLE_STRING" => Some(DataType::Text(0)),
        _ => None,
    };
    let bits = || number("BIT").filter(|bits| (1..=8).contains(bits)).map(DataType::Bits);
    let int = || number("INT").filter(|bits| whole((*bits).into())).map(DataType::Int);
    let uint = || number("UINT").filter(|bits| whole((*bits).into())).map(DataType::Uint);
    let text = || {
        let length = name.strip_prefix("STRING(").or_else(|| name.strip_prefix("VISIBLE_STRING("));
        length
            .and_then(|rest| rest.strip_suffix(')'))
            .and_then(|it| it.trim().parse().ok())
            .map(DataType::Text)
    };
    basic
        .or_else(bits)
        .or_else(int)
        .or_else(uint)
        .or_else(text)
        .or_else(|| octets(&name))
        .or_else(|| name.replace("WSTRING(", "UNICODE_STRING(").parse().ok())
}
