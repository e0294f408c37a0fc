//! Sync managers, mailbox, EEPROM and what a master writes at start-up.

use super::{Judged, Presence, Whole, less, presence};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::Versions;
use crate::model::{Device, Difference, Protocol, SyncManager};

/// The bits of a control byte that say how the area is buffered and who writes it (ETG.1000.4, sync manager control).
const BUFFER_AND_DIRECTION: u8 = 0x0F;

/// The steps of a path that lead to a configuration.
const TO_A_CONFIGURATION: usize = 2;

pub(super) fn sync_manager(versions: Versions<'_>, path: &[&str]) -> Option<&'static Kind> {
    let (key, rest) = path.split_first()?;
    let [Some(old), Some(new)] = [versions.old, versions.new].map(|device| manager(device, key)) else {
        return Some(&kinds::MOVED_SYNC_MANAGER);
    };
    Some(match rest {
        // The length of process data follows from what is assigned, and whether there is any.
        ["size" | "enable"] if versions.old.carried_bytes(old) != versions.new.carried_bytes(new) => {
            return None;
        }
        ["control"] if (old.control ^ new.control) & BUFFER_AND_DIRECTION == 0 => &kinds::CHANGED_WATCHDOG,
        ["address" | "size" | "control"] => &kinds::MOVED_SYNC_MANAGER,
        ["pdos"] => &kinds::CHANGED_ASSIGNMENT,
        ["slots"] if old.pdos != new.pdos => return None,
        ["slots"] if new.slots < old.slots => &kinds::RESTRICTED_PDO,
        ["slots"] => &kinds::LOOSENED_PDO,
        ["max_size"] => area(old.max_size, new.max_size),
        ["min_size"] => area(new.min_size, old.min_size),
        ["source"] => &kinds::CHANGED_TEXT,
        _ => &kinds::MOVED_SYNC_MANAGER,
    })
}

fn manager<'d>(device: &'d Device, key: &str) -> Option<&'d SyncManager> {
    device.sync_managers.iter().find(|manager| manager.id == *key)
}

fn area(old: Option<u16>, new: Option<u16>) -> &'static Kind {
    if less(old, new) { &kinds::REDUCED_AREA } else { &kinds::ENLARGED_AREA }
}

pub(super) fn mailbox(versions: Versions<'_>, path: &[&str], difference: &Difference) -> &'static Kind {
    match (path, presence(difference)) {
        ([], Presence::Gone) => &kinds::REMOVED_COE,
        ([], _) => &kinds::ADDED_ABILITY,
        (["protocols"], _) => protocols(versions),
        (["source"], _) => &kinds::CHANGED_TEXT,
        _ if difference.second.as_deref() == Some("true") => &kinds::ADDED_ABILITY,
        _ => &kinds::REMOVED_ABILITY,
    }
}

fn protocols(versions: Versions<'_>) -> &'static Kind {
    let of = |device: &Device| {
        device.mailbox.as_ref().map(|mailbox| mailbox.protocols.clone()).unwrap_or_default()
    };
    let new = of(versions.new);
    let gone: Vec<Protocol> = of(versions.old).into_iter().filter(|old| !new.contains(old)).collect();
    match gone.as_slice() {
        [] => &kinds::ADDED_ABILITY,
        gone if gone.contains(&Protocol::Coe) => &kinds::REMOVED_COE,
        _ => &kinds::REMOVED_ABILITY,
    }
}

/// More from the E-bus than before is what may be missing there.
pub(super) fn current(versions: Versions<'_>) -> &'static Kind {
    let taken = |device: &Device| device.ebus_current.unwrap_or(0);
    if taken(versions.new) > taken(versions.old) { &kinds::RAISED_CURRENT } else { &kinds::LOWERED_CURRENT }
}

pub(super) fn eeprom(field: &str) -> &'static Kind {
    match field {
        "config_data" | "bootstrap" => &kinds::CHANGED_HARDWARE,
        _ => &kinds::CHANGED_TEXT,
    }
}

pub(super) fn configuration(path: &[&str], difference: &Difference) -> Option<Judged> {
    let kind: &'static Kind = match (path, presence(difference)) {
        ([_], Presence::Gone) => &kinds::CHANGED_START_UP,
        ([_], _) => &kinds::ADDED_START_UP,
        ([_, "name"], _) => &kinds::RENAMED,
        ([_, "about" | "source"], _) => &kinds::CHANGED_TEXT,
        _ => return Some(start_up()),
    };
    Some(kind.into())
}

/// Whatever differs in a configuration, its list of writes is another one.
fn start_up() -> Judged {
    let whole =
        Whole { depth: TO_A_CONFIGURATION, old: "its writes".to_owned(), new: "other writes".to_owned() };
    Judged { kind: &kinds::CHANGED_START_UP, of_whole: Some(whole) }
}
