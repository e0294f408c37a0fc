//! Entries of objects.

use super::{Presence, function, means_else, presence, units};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::Versions;
use crate::model::{Access, DataType, Difference, Entry, Index, Mappable, Value, WriteWindow};

/// The device's own name and versions, CiA 301.
const LABELS: [Index; 3] = [Index(0x1008), Index(0x1009), Index(0x100A)];

/// The supported drive modes, which follow from the modes.
const SUPPORTED_MODES: Index = Index(0x6502);

pub(super) fn judge(
    versions: Versions<'_>,
    key: &str,
    path: &[&str],
    difference: &Difference,
) -> Option<&'static Kind> {
    let (old, new) = versions.entry(key)?;
    Some(match path {
        ["data_type" | "default" | "min" | "max"] if LABELS.contains(&old.address.index) => {
            &kinds::CHANGED_LABEL
        }
        ["default"] if is_of_modes(versions, old) => return None,
        ["data_type"] => data_type(old.data_type, new.data_type),
        ["access"] => wider(lost(access(old.access), access(new.access))),
        ["written"] => wider(lost(window(old.written), window(new.written))),
        ["pdo"] if lost(mappable(old.pdo), mappable(new.pdo)) => &kinds::UNMAPPABLE_ENTRY,
        ["pdo"] => &kinds::MAPPABLE_ENTRY,
        ["default"] => default(difference),
        ["min"] => limit(new, narrower(&old.min, &new.min, |old, new| new > old)),
        ["max"] => limit(new, narrower(&old.max, &new.max, |old, new| new < old)),
        ["values", rest @ ..] => value(rest, difference)?,
        ["unit"] => units::of_entry(versions, old, new),
        ["trigger", ..] => &kinds::CHANGED_TRIGGER,
        ["functional"] => function(difference),
        ["safety"] => &kinds::CHANGED_SAFETY,
        ["backup"] if new.backup => &kinds::SAVED_VALUE,
        ["setting"] if new.setting => &kinds::SAVED_VALUE,
        ["backup" | "setting"] => &kinds::UNSAVED_VALUE,
        ["name"] => &kinds::RENAMED,
        // The word follows from the name, unless it is chosen.
        ["id"] if old.name == new.name => &kinds::RENAMED,
        ["id" | "address"] => return None,
        _ => &kinds::CHANGED_TEXT,
    })
}

fn is_of_modes(versions: Versions<'_>, entry: &Entry) -> bool {
    let codes = |modes: &[crate::model::Mode]| modes.iter().map(|mode| mode.code).collect::<Vec<_>>();
    entry.address.index == SUPPORTED_MODES && codes(&versions.old.modes) != codes(&versions.new.modes)
}

fn data_type(old: DataType, new: DataType) -> &'static Kind {
    // Numbers without a sign and rows of bits of the same width are the same bytes with the same meaning.
    let plain =
        |data_type| matches!(data_type, DataType::Uint(_) | DataType::Bitstring(_) | DataType::Bits(_));
    match old.bits() == new.bits() {
        false => &kinds::CHANGED_WIDTH,
        true if plain(old) && plain(new) => &kinds::RESPELT_TYPE,
        true => &kinds::CHANGED_TYPE,
    }
}

/// What can be done: read, write.
fn access(access: Access) -> [bool; 3] {
    match access {
        Access::Ro | Access::Const => [true, false, false],
        Access::Wo => [false, true, false],
        Access::Rw => [true, true, false],
    }
}

/// The states in which a value may be written.
fn window(window: Option<WriteWindow>) -> [bool; 3] {
    window.map_or([true; 3], WriteWindow::states)
}

/// The directions in which a value can be mapped.
fn mappable(mappable: Mappable) -> [bool; 3] {
    match mappable {
        Mappable::None => [false, false, false],
        Mappable::Rx => [true, false, false],
        Mappable::Tx => [false, true, false],
        Mappable::RxTx => [true, true, false],
    }
}

/// Whether something that could be done can be done no longer.
fn lost(old: [bool; 3], new: [bool; 3]) -> bool {
    old.iter().zip(new).any(|(old, new)| *old && !new)
}

fn wider(is_lost: bool) -> &'static Kind {
    if is_lost { &kinds::NARROWED_ACCESS } else { &kinds::WIDENED_ACCESS }
}

fn default(difference: &Difference) -> &'static Kind {
    match presence(difference) {
        Presence::Both => &kinds::CHANGED_DEFAULT,
        Presence::Come | Presence::Gone => &kinds::STATED_DEFAULT,
    }
}

/// Whether a limit lets less through than before.
fn narrower(old: &Option<Value>, new: &Option<Value>, is_narrower: fn(i128, i128) -> bool) -> bool {
    match (old, new) {
        (_, None) => false,
        (None, Some(_)) => true,
        (Some(old), Some(new)) => match (old.integer(), new.integer()) {
            (Some(old), Some(new)) => is_narrower(old, new),
            // Nothing is known of the order of other values.
            _ => true,
        },
    }
}

/// What masters write is refused where it was accepted; what they read goes where it did not go before.
fn limit(entry: &Entry, is_narrower: bool) -> &'static Kind {
    let is_written = matches!(entry.access, Access::Rw | Access::Wo);
    if is_narrower == is_written { &kinds::CHANGED_LIMITS } else { &kinds::LOOSENED_LIMITS }
}

/// A named value.
pub(super) fn value(path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    Some(match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::CHANGED_VALUE,
        ([_], Presence::Come) => &kinds::ADDED_VALUE,
        ([_, "name"], _) if means_else(difference) => &kinds::CHANGED_VALUE,
        ([_, "name"], _) => &kinds::RENAMED,
        ([_, "last"], _) => &kinds::CHANGED_VALUE,
        ([_, "id"], _) => return None,
        _ => &kinds::CHANGED_TEXT,
    })
}
