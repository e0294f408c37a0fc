//! Basic data types by their names in ETG.1020.

use super::element::Element;
use crate::model::{DataType, Item};

/// The name, which is that of IEC 61131-3 where there is one.
pub(super) fn name(data_type: DataType) -> String {
    match data_type {
        DataType::Bool => "BOOL".into(),
        DataType::Int(8) => "SINT".into(),
        DataType::Int(16) => "INT".into(),
        DataType::Int(32) => "DINT".into(),
        DataType::Int(64) => "LINT".into(),
        DataType::Int(bits) => format!("INT{bits}"),
        DataType::Uint(8) => "USINT".into(),
        DataType::Uint(16) => "UINT".into(),
        DataType::Uint(32) => "UDINT".into(),
        DataType::Uint(64) => "ULINT".into(),
        DataType::Uint(bits) => format!("UINT{bits}"),
        DataType::Real32 => "REAL".into(),
        DataType::Real64 => "LREAL".into(),
        DataType::Bitstring(8) => "BYTE".into(),
        DataType::Bitstring(16) => "WORD".into(),
        DataType::Bitstring(_) => "DWORD".into(),
        DataType::Bits(bits) => format!("BIT{bits}"),
        DataType::Text(bytes) => format!("STRING({bytes})"),
        DataType::Octets(bytes) => array(bytes, "BYTE"),
        DataType::Unicode(units) => array(units, "UINT"),
        DataType::Array(item, count) => array(count, &name(item.data_type())),
    }
}

fn array(elements: u16, of: &str) -> String {
    format!("ARRAY [0..{}] OF {of}", elements.saturating_sub(1))
}

/// The type of the elements of an array, and how many it has.
pub(super) fn elements(data_type: DataType) -> Option<(DataType, u16)> {
    match data_type {
        DataType::Octets(bytes) => Some((DataType::Bitstring(8), bytes)),
        DataType::Unicode(units) => Some((DataType::Uint(16), units)),
        DataType::Array(item, count) => Some((item.data_type(), count)),
        _ => None,
    }
}

/// The name of a type that says of a value no more than how wide it is.
pub(super) fn of_width(bits: u32) -> String {
    match bits {
        8 => "BYTE".into(),
        16 => "WORD".into(),
        32 => "DWORD".into(),
        // ETG.1020 has bits up to 16, and of whole bytes no other than numbers and arrays.
        ..=16 => format!("BIT{bits}"),
        24 | 40 | 48 | 56 => format!("UINT{bits}"),
        64 => "ULINT".into(),
        _ if bits.is_multiple_of(8) => format!("ARRAY [0..{}] OF BYTE", bits / 8 - 1),
        _ => format!("ARRAY [0..{}] OF BIT", bits - 1),
    }
}

/// The place of a type among its like: bits, numbers by sign and width, text by length.
pub(super) fn order(data_type: DataType) -> (u8, u32) {
    let kind = match data_type {
        DataType::Bool => 0,
        DataType::Bits(_) => 1,
        DataType::Bitstring(_) => 2,
        DataType::Int(_) => 3,
        DataType::Uint(_) => 4,
        DataType::Real32 | DataType::Real64 => 5,
        DataType::Text(_) => 6,
        DataType::Octets(_) => 7,
        DataType::Unicode(_) => 8,
        DataType::Array(Item::Int8, _) => 9,
        DataType::Array(Item::Int16, _) => 10,
        DataType::Array(Item::Int32, _) => 11,
        DataType::Array(Item::Uint32, _) => 12,
    };
    (kind, data_type.bits())
}

/// The declaration.
pub(super) fn declaration(data_type: DataType) -> Element {
    let elements = elements(data_type);
    let info = elements.map(|(_, count)| {
        let first = Element::leaf("LBound", 0);
        Element::new("ArrayInfo").child(first).child(Element::leaf("Elements", count))
    });
    Element::new("DataType")
        .child(Element::leaf("Name", name(data_type)))
        .child(elements.map(|(of, _)| Element::leaf("BaseType", name(of))))
        .child(Element::leaf("BitSize", data_type.bits()))
        .child(info)
}
