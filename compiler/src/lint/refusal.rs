//! Why a device does not take a value, as its dictionary says.

use super::lookup;
use crate::model::{Entry, Value, WriteWindow};

/// What keeps a value from being taken.
pub(super) struct Refusal {
    /// The key of the entry that says so.
    pub(super) key: &'static str,
    /// Why, about the entry.
    pub(super) why: String,
    /// What comes of it, after "which".
    pub(super) comes: &'static str,
}

/// The key of an entry by which a value is refused, or does nothing, why, and what comes of it. A configuration writes at a
/// change of the EtherCAT state, a person whenever it can be done.
pub(super) fn refusal(entry: &Entry, value: &Value, transition: Option<&str>) -> Option<Refusal> {
    let is_closed = |window: &WriteWindow| transition.is_some_and(|transition| !is_open(*window, transition));
    let (key, why) = if !entry.functional {
        return Some(Refusal {
            key: "functional",
            why: "has no function".to_owned(),
            comes: "does nothing there",
        });
    } else if !entry.access.writable() {
        ("access", "cannot be written".to_owned())
    } else if let Some(window) = entry.written.filter(is_closed) {
        ("written", format!("is written in {} only", window.name()))
    } else if entry.max.as_ref().is_some_and(|max| lookup::above(value, max)) {
        ("max", "is too large".to_owned())
    } else if entry.min.as_ref().is_some_and(|min| lookup::above(min, value)) {
        ("min", "is too small".to_owned())
    } else {
        return None;
    };
    Some(Refusal { key, why, comes: "the device refuses" })
}

/// Whether an entry is written in the state that a change begins with, where the mailbox is there; that is Pre-Operational
/// on the way from Init.
fn is_open(window: WriteWindow, transition: &str) -> bool {
    let [pre_operational, safe_operational, operational] = window.states();
    match transition.chars().next() {
        Some('S') => safe_operational,
        Some('O') => operational,
        _ => pre_operational,
    }
}
