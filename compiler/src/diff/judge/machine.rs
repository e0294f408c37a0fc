//! The state machine of a drive.

use super::{Presence, presence};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::Versions;
use crate::model::Difference;

pub(super) fn state(path: &[&str], difference: &Difference) -> &'static Kind {
    match (path, presence(difference)) {
        ([_], Presence::Come) => &kinds::CHANGED_BEHAVIOUR,
        ([_] | [_, "pattern"], _) => &kinds::CHANGED_STATE_MACHINE,
        ([_, "brake" | "low_level_power" | "high_level_power" | "drive_function" | "configuration"], _) => {
            &kinds::CHANGED_BEHAVIOUR
        }
        ([_, "name"], _) => &kinds::RENAMED,
        _ => &kinds::CHANGED_TEXT,
    }
}

pub(super) fn command(path: &[&str], difference: &Difference) -> &'static Kind {
    match (path, presence(difference)) {
        ([_], Presence::Come) => &kinds::ADDED_TRANSITION,
        ([_] | [_, "pattern" | "transitions"], _) => &kinds::CHANGED_STATE_MACHINE,
        ([_, "ignored_in"], _) => &kinds::CHANGED_BEHAVIOUR,
        ([_, "name"], _) => &kinds::RENAMED,
        _ => &kinds::CHANGED_TEXT,
    }
}

pub(super) fn transition(versions: Versions<'_>, path: &[&str], difference: &Difference) -> &'static Kind {
    let is_new = difference.second.as_deref() == Some("true");
    match (path, presence(difference)) {
        ([key], Presence::Come) if happens_by_itself(versions, key) => &kinds::CHANGED_BEHAVIOUR,
        ([_], Presence::Come) => &kinds::ADDED_TRANSITION,
        ([_, "supported"], _) if is_new => &kinds::ADDED_TRANSITION,
        ([_] | [_, "from" | "to" | "pattern" | "supported"], _) => &kinds::CHANGED_STATE_MACHINE,
        ([_, "automatic" | "events" | "interlocks" | "axes" | "power"], _) => &kinds::CHANGED_BEHAVIOUR,
        ([_, "command"], _) => &kinds::RENAMED,
        _ => &kinds::CHANGED_TEXT,
    }
}

fn happens_by_itself(versions: Versions<'_>, number: &str) -> bool {
    let transition =
        versions.new.transitions.iter().find(|transition| transition.number.to_string() == number);
    transition.is_some_and(|transition| transition.automatic || !transition.events.is_empty())
}
