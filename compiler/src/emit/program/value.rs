//! What a field of process data is in a program.

use serde::Serialize;

use crate::model::{Address, DataType, Device, Mapped, Word};

/// How a field is to be taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::emit) enum Kind {
    /// A bit.
    Bool,
    /// A whole number with a sign.
    Int,
    /// A whole number without.
    Uint,
    /// An IEEE 754 number.
    Real,
    /// Bytes without a meaning as a number.
    Bytes,
}

/// Kind, and the width in bits of the value: what its type has, or what is mapped where no type says anything.
pub(super) fn of(device: &Device, mapped: &Mapped) -> (Kind, u32) {
    let word = mapped.address.and_then(|address| word(device, address));
    of_type(mapped.data_type, mapped.bits, word.is_some())
}

/// As [`of`], of what has a type and a width; whether it is a word, whose bits have names.
pub(in crate::emit) fn of_type(data_type: Option<DataType>, bits: u32, is_word: bool) -> (Kind, u32) {
    match data_type {
        Some(DataType::Bool | DataType::Bits(1)) => (Kind::Bool, 1),
        Some(data_type @ DataType::Int(_)) if !is_word => (Kind::Int, data_type.bits()),
        Some(
            DataType::Int(width) | DataType::Uint(width) | DataType::Bitstring(width) | DataType::Bits(width),
        ) => (Kind::Uint, width.into()),
        Some(data_type @ (DataType::Real32 | DataType::Real64)) if data_type.bits() == bits => {
            (Kind::Real, bits)
        }
        Some(DataType::Text(_) | DataType::Octets(_) | DataType::Unicode(_)) => (Kind::Bytes, bits),
        _ if bits == 1 => (Kind::Bool, 1),
        _ if bits <= 64 => (Kind::Uint, bits),
        _ => (Kind::Bytes, bits),
    }
}

/// The word at an address, on whatever axis: its bits have names, and no sign, whatever the manual calls its type.
fn word(device: &Device, address: Address) -> Option<&Word> {
    let leading = device.object(address.index).map_or(address.index, |object| object.leading);
    device
        .words
        .iter()
        .find(|word| (word.address.index, word.address.subindex) == (leading, address.subindex))
}
