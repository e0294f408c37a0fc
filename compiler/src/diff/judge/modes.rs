//! Modes of operation and homing methods.

use super::{Presence, means_else, presence, words};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::Versions;
use crate::model::{Device, Difference};

pub(super) fn mode(versions: Versions<'_>, path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    let aliases = |device: &Device, key: &str| -> Vec<i16> {
        let mode = device.modes.iter().find(|mode| mode.code.to_string() == key);
        mode.map(|mode| mode.aliases.clone()).unwrap_or_default()
    };
    Some(match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::REMOVED_MODE,
        ([_], _) => &kinds::ADDED_MODE,
        ([key, "aliases"], _) if loses(&aliases(versions.old, key), &aliases(versions.new, key)) => {
            &kinds::REMOVED_MODE
        }
        ([_, "aliases"], _) => &kinds::ADDED_MODE,
        ([_, "control_bits" | "status_bits", rest @ ..], _) => return words::field(rest, difference),
        ([_, "supported_bit" | "homing_bits", ..], _) => &kinds::MOVED_BITS,
        ([_, "cyclic"], _) => &kinds::CHANGED_BEHAVIOUR,
        ([_, "name" | "id"], _) => &kinds::RENAMED,
        _ => &kinds::CHANGED_TEXT,
    })
}

pub(super) fn homing_method(
    versions: Versions<'_>,
    path: &[&str],
    difference: &Difference,
) -> Option<&'static Kind> {
    let aliases = |device: &Device, key: &str| -> Vec<i8> {
        let method = device.homing_methods.iter().find(|method| method.number.to_string() == key);
        method.map(|method| method.aliases.clone()).unwrap_or_default()
    };
    Some(match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::CHANGED_HOMING,
        ([_], _) => &kinds::ADDED_HOMING,
        ([key, "aliases"], _) if loses(&aliases(versions.old, key), &aliases(versions.new, key)) => {
            &kinds::CHANGED_HOMING
        }
        ([_, "aliases"], _) => &kinds::ADDED_HOMING,
        ([_, "direction" | "pulse" | "target"], _) => &kinds::CHANGED_HOMING,
        ([_, "name"], _) if means_else(difference) => &kinds::CHANGED_HOMING,
        ([_, "name"], _) => &kinds::RENAMED,
        ([_, "id"], _) => return None,
        _ => &kinds::CHANGED_TEXT,
    })
}

/// Whether a list has lost something.
fn loses<T: PartialEq>(old: &[T], new: &[T]) -> bool {
    old.iter().any(|item| !new.contains(item))
}
