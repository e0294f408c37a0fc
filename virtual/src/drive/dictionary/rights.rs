//! Rights and bounds of entries, from the words of the model to those of the runtime.

use devc::model::{Access, Bounds, Entry, Mappable};
use devc_runtime::sdo::{self, Limits, Place, Range};

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
