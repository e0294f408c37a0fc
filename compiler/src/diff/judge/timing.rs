//! Time.

use super::{Presence, presence};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::Versions;
use crate::model::{CycleTime, Device, Difference, SyncMode};

pub(super) fn sync_mode(versions: Versions<'_>, path: &[&str], difference: &Difference) -> &'static Kind {
    match (path, presence(difference)) {
        ([key], Presence::Come) if first(versions.new) != Some(key) => &kinds::ADDED_SYNC_MODE,
        ([_, "about" | "source"], _) => &kinds::CHANGED_TEXT,
        _ => &kinds::CHANGED_SYNC_MODE,
    }
}

/// The mode that a master takes if nothing is said.
fn first(device: &Device) -> Option<&str> {
    let chosen = device.sync_modes.iter().find(|mode| mode.default);
    chosen.or(device.sync_modes.first()).map(|mode: &SyncMode| mode.id.as_str())
}

pub(super) fn cycle_time(versions: Versions<'_>, path: &[&str], difference: &Difference) -> &'static Kind {
    let both = |id: &str| {
        let [old, new] =
            [versions.old, versions.new].map(|device| device.cycle_times.iter().find(|time| time.id == id));
        old.zip(new)
    };
    match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::SHORTENED_TIME,
        ([_], _) => &kinds::LENGTHENED_TIME,
        ([_, "name"], _) => &kinds::RENAMED,
        ([_, "about" | "source"], _) => &kinds::CHANGED_TEXT,
        ([id, ..], _) => length(both(id).is_some_and(|(old, new)| is_longer(old, new))),
        ([], _) => &kinds::CHANGED_TEXT,
    }
}

/// Whether a cycle that was possible is so no longer.
fn is_longer(old: &CycleTime, new: &CycleTime) -> bool {
    let lost = old.choices.iter().any(|choice| !new.choices.contains(choice));
    let limited = old.choices.is_empty() && !new.choices.is_empty();
    lost && !new.choices.is_empty() || limited || new.min > old.min || holds_for_more(old, new)
}

/// Whether a limit holds for a mode for which it did not hold.
fn holds_for_more(old: &CycleTime, new: &CycleTime) -> bool {
    let is_new = |mode| !old.modes.is_empty() && !old.modes.contains(mode);
    new.modes.iter().any(is_new) || new.modes.is_empty() && !old.modes.is_empty()
}

pub(super) fn dead_time(versions: Versions<'_>, path: &[&str], difference: &Difference) -> &'static Kind {
    let (old, new) = (versions.old.dead_time.as_ref(), versions.new.dead_time.as_ref());
    match (path, presence(difference)) {
        ([], Presence::Gone) => &kinds::SHORTENED_TIME,
        ([], _) => &kinds::LENGTHENED_TIME,
        (["cycles"], _) => length(new.map(|time| time.cycles) > old.map(|time| time.cycles)),
        (["plus"], _) => length(new.map(|time| time.plus) > old.map(|time| time.plus)),
        _ => &kinds::CHANGED_TEXT,
    }
}

fn length(is_longer: bool) -> &'static Kind {
    if is_longer { &kinds::LENGTHENED_TIME } else { &kinds::SHORTENED_TIME }
}
