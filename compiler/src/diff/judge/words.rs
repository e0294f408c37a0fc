//! Words made of bits, and codes.

use super::{Presence, entry, means_else, presence};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::model::Difference;

pub(super) fn word(path: &[&str], difference: &Difference) -> &'static Kind {
    match (path, presence(difference)) {
        ([], Presence::Come) => &kinds::ADDED_BITS,
        ([] | ["address" | "bits"], _) => &kinds::MOVED_BITS,
        (["fields", rest @ ..], _) => field(rest, difference).unwrap_or(&kinds::CHANGED_TEXT),
        (["name"], _) => &kinds::RENAMED,
        _ => &kinds::CHANGED_TEXT,
    }
}

/// Bits of a word.
pub(super) fn field(path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    Some(match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::MOVED_BITS,
        ([_], _) => &kinds::ADDED_BITS,
        ([_, "high"], _) => &kinds::MOVED_BITS,
        ([_, "reserved" | "per_mode"], _) if difference.first.as_deref() == Some("true") => {
            &kinds::ADDED_BITS
        }
        ([_, "reserved" | "per_mode"], _) => &kinds::MOVED_BITS,
        ([_, "name"], _) if is_free(difference) => &kinds::ADDED_BITS,
        ([_, "name"], _) if means_else(difference) => &kinds::MOVED_BITS,
        ([_, "name"], _) => &kinds::RENAMED,
        ([_, "values", rest @ ..], _) => return entry::value(rest, difference),
        ([_, "id" | "key"], _) => return None,
        _ => &kinds::CHANGED_TEXT,
    })
}

/// Whether bits meant nothing before.
fn is_free(difference: &Difference) -> bool {
    difference.first.as_deref() == Some("reserved")
}

/// Messages of the diagnosis history, told apart by their text ids.
pub(super) fn message(path: &[&str], difference: &Difference) -> &'static Kind {
    match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::CHANGED_ERROR,
        ([_], _) => &kinds::ADDED_ERROR,
        ([_, "text"], _) if means_else(difference) => &kinds::CHANGED_ERROR,
        _ => &kinds::CHANGED_TEXT,
    }
}

/// Error codes, codes of the vendor and AL status codes.
pub(super) fn error(path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    Some(match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::CHANGED_ERROR,
        ([_], _) => &kinds::ADDED_ERROR,
        ([_, "last" | "register" | "vendor_codes"], _) => &kinds::CHANGED_ERROR,
        ([_, "name"], _) if means_else(difference) => &kinds::CHANGED_ERROR,
        ([_, "name"], _) => &kinds::RENAMED,
        ([_, "id"], _) => return None,
        _ => &kinds::CHANGED_TEXT,
    })
}
