//! Modes of operation and homing methods.

use super::{Presence, means_else, presence, words};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::model::Difference;

pub(super) fn mode(path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    Some(match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::REMOVED_MODE,
        ([_], _) => &kinds::ADDED_MODE,
        ([_, "aliases"], _) if loses(difference) => &kinds::REMOVED_MODE,
        ([_, "aliases"], _) => &kinds::ADDED_MODE,
        ([_, "control_bits" | "status_bits", rest @ ..], _) => return words::field(rest, difference),
        ([_, "supported_bit" | "homing_bits", ..], _) => &kinds::MOVED_BITS,
        ([_, "cyclic"], _) => &kinds::CHANGED_BEHAVIOUR,
        ([_, "name" | "id"], _) => &kinds::RENAMED,
        _ => &kinds::CHANGED_TEXT,
    })
}

pub(super) fn homing_method(path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    Some(match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::CHANGED_HOMING,
        ([_], _) => &kinds::ADDED_HOMING,
        ([_, "aliases"], _) if loses(difference) => &kinds::CHANGED_HOMING,
        ([_, "aliases"], _) => &kinds::ADDED_HOMING,
        ([_, "direction" | "pulse" | "target"], _) => &kinds::CHANGED_HOMING,
        ([_, "name"], _) if means_else(difference) => &kinds::CHANGED_HOMING,
        ([_, "name"], _) => &kinds::RENAMED,
        ([_, "id"], _) => return None,
        _ => &kinds::CHANGED_TEXT,
    })
}

/// Whether a list has lost something.
fn loses(difference: &Difference) -> bool {
    let items = |shown: &Option<String>| -> Vec<String> {
        shown.iter().flat_map(|list| list.split(", ")).map(str::to_owned).collect()
    };
    let new = items(&difference.second);
    items(&difference.first).iter().any(|old| !old.is_empty() && !new.contains(old))
}
