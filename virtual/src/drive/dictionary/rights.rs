//! Types, rights and bounds of entries, from the words of the model to those of the runtime.

use devc::model::{self, Access, Bounds, Entry, Mappable};
use devc_runtime::sdo::{self, DataType, Limits, Place, Range};

use super::Home;
use crate::drive::forever;

/// Who may do what with an entry, and when.
pub(super) fn access(entry: &Entry) -> sdo::Access {
    let readable = if entry.access.readable() { sdo::Access::READ } else { sdo::Access(0) };
    let rights = if entry.access.writable() { readable.and(written(entry)) } else { readable };
    match entry.pdo {
        Mappable::None => rights,
        Mappable::Rx => rights.and(sdo::Access::RX_PDO),
        Mappable::Tx => rights.and(sdo::Access::TX_PDO),
        Mappable::RxTx => rights.and(sdo::Access::RX_PDO).and(sdo::Access::TX_PDO),
    }
}

/// The states in which an entry may be written.
fn written(entry: &Entry) -> sdo::Access {
    let states = [
        sdo::Access::WRITE_PRE_OPERATIONAL,
        sdo::Access::WRITE_SAFE_OPERATIONAL,
        sdo::Access::WRITE_OPERATIONAL,
    ];
    match entry.written {
        None => sdo::Access::WRITE,
        Some(window) => {
            let within = states.into_iter().zip(window.states()).filter(|(_, is_within)| *is_within);
            within.fold(sdo::Access(0), |all, (state, _)| all.and(state))
        }
    }
}

/// The number of a type (ETG.1020, base data types).
pub(super) fn data_type(data_type: model::DataType) -> DataType {
    use model::DataType as Type;
    match data_type {
        Type::Bool => DataType::BOOLEAN,
        Type::Int(8) => DataType::INTEGER8,
        Type::Int(16) => DataType::INTEGER16,
        Type::Int(24) => DataType::INTEGER24,
        Type::Int(32) => DataType::INTEGER32,
        Type::Int(40) => DataType::INTEGER40,
        Type::Int(48) => DataType::INTEGER48,
        Type::Int(56) => DataType::INTEGER56,
        Type::Int(_) => DataType::INTEGER64,
        Type::Uint(8) => DataType::UNSIGNED8,
        Type::Uint(16) => DataType::UNSIGNED16,
        Type::Uint(24) => DataType::UNSIGNED24,
        Type::Uint(32) => DataType::UNSIGNED32,
        Type::Uint(40) => DataType::UNSIGNED40,
        Type::Uint(48) => DataType::UNSIGNED48,
        Type::Uint(56) => DataType::UNSIGNED56,
        Type::Uint(_) => DataType::UNSIGNED64,
        Type::Real32 => DataType::REAL32,
        Type::Real64 => DataType::REAL64,
        Type::Text(_) => DataType::VISIBLE_STRING,
        Type::Octets(_) => DataType::OCTET_STRING,
        Type::Unicode(_) => DataType::UNICODE_STRING,
        Type::Bitstring(8) => DataType(0x001E),
        Type::Bitstring(16) => DataType(0x001F),
        Type::Bitstring(_) => DataType(0x0020),
        Type::Bits(bits) => DataType(0x002F_u16.saturating_add(bits.into())),
    }
}

/// The bounds of the values that have any and can be written, ascending by place.
pub(super) fn ranges(homes: &[Home<'_>]) -> &'static [Range] {
    let kept = homes.iter().flat_map(|home| {
        let items = home.kept.iter().zip(0..=u8::MAX);
        items.map(|(entry, item)| (*entry, Place { field: home.field, item, axis: 0 }))
    });
    let writable = kept.filter(|(entry, _)| matches!(entry.access, Access::Wo | Access::Rw));
    forever::all(writable.filter_map(|(entry, place)| Some(Range { place, limits: limits(entry.bounds()?) })))
}

fn limits(bounds: Bounds) -> Limits {
    let signed = |bound: i128| i64::try_from(bound).unwrap_or(if bound < 0 { i64::MIN } else { i64::MAX });
    let unsigned = |bound: i128| u64::try_from(bound).unwrap_or(if bound < 0 { 0 } else { u64::MAX });
    match bounds {
        Bounds::Signed(min, max) => Limits::Signed(signed(min), signed(max)),
        Bounds::Unsigned(min, max) => Limits::Unsigned(unsigned(min), unsigned(max)),
        Bounds::Real(min, max) => Limits::Real(min, max),
    }
}
