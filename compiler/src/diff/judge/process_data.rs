//! PDOs.

use super::{Judged, Presence, Whole, less, presence};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::{Versions, index};
use crate::model::{Device, Difference, Index, Pdo};

/// The steps of a path that lead to a PDO.
const TO_A_PDO: usize = 2;

pub(super) fn judge(versions: Versions<'_>, path: &[&str], difference: &Difference) -> Option<Judged> {
    let (key, rest) = path.split_first()?;
    if rest.is_empty() {
        return Some(match presence(difference) {
            Presence::Gone => (&kinds::REMOVED_PDO).into(),
            _ => (&kinds::ADDED_PDO).into(),
        });
    }
    let (old, new) = versions.pdo(key)?;
    let kind: &'static Kind = match rest {
        ["entries", ..] if layout(old) == layout(new) => return same_layout(versions, old, new, rest),
        ["entries", ..] => {
            let kind = content(versions, index(key)?, old);
            let whole = Whole { depth: TO_A_PDO, old: shown(old), new: shown(new) };
            return Some(Judged { kind, of_whole: Some(whole) });
        }
        ["direction"] => &kinds::REMOVED_PDO,
        ["fixed" | "mandatory"] => restricted(difference.second.as_deref() == Some("true")),
        // Together with a PDO that was not there it cannot have been assigned.
        ["excludes"] => restricted(
            new.excludes
                .iter()
                .any(|other| !old.excludes.contains(other) && versions.old.pdo(*other).is_some()),
        ),
        ["max_bytes"] => restricted(less(old.max_bytes, new.max_bytes)),
        ["max_entries"] => restricted(less(old.max_entries, new.max_entries)),
        ["virtual"] | ["oversampling", ..] => content(versions, index(key)?, old),
        ["name"] => &kinds::RENAMED,
        ["index" | "leading" | "axis"] => return None,
        _ => &kinds::CHANGED_TEXT,
    };
    Some(kind.into())
}

/// What is where in a PDO.
fn layout(pdo: &Pdo) -> Vec<(Option<crate::model::Address>, u32)> {
    pdo.entries.iter().map(|entry| (entry.address, entry.bits)).collect()
}

/// The layout of a PDO, for people.
fn shown(pdo: &Pdo) -> String {
    let entries = pdo.entries.iter().map(|entry| match entry.address {
        Some(address) => address.to_string(),
        None => format!("{} bits", entry.bits),
    });
    let entries: Vec<String> = entries.collect();
    format!("{} bytes: {}", pdo.bytes(), entries.join(", "))
}

/// What it means that the content of a PDO is another one.
fn content(versions: Versions<'_>, index: Index, old: &Pdo) -> &'static Kind {
    match (is_assigned(versions.old, index), old.fixed) {
        (true, _) => &kinds::CHANGED_IMAGE,
        (false, true) => &kinds::CHANGED_FIXED_PDO,
        (false, false) => &kinds::CHANGED_MAPPING,
    }
}

fn is_assigned(device: &Device, index: Index) -> bool {
    device.sync_managers.iter().any(|manager| manager.pdos.contains(&index))
}

/// The layout is the same: what differs is what entries are called, and how their bits are read.
fn same_layout(versions: Versions<'_>, old: &Pdo, new: &Pdo, path: &[&str]) -> Option<Judged> {
    match path {
        [_, _, "name"] => Some((&kinds::RENAMED).into()),
        [_, _, "names" | "about", ..] => Some((&kinds::CHANGED_TEXT).into()),
        [_, place, "own_type"] => {
            // Where only the object has another type, its own change tells.
            let place: usize = place.parse().ok()?;
            let told = |pdo: &Pdo| Some(pdo.entries.get(place)?.told_type());
            (told(old)? != told(new)?).then(|| (&kinds::RESPELT_TYPE).into())
        }
        [_, place, "data_type"] => {
            let place: usize = place.parse().ok()?;
            let (old, new) = (old.entries.get(place)?, new.entries.get(place)?);
            // The type is that of the object, of which its own change tells; without an object it is all there is.
            let is_known =
                |device: &Device| old.address.is_some_and(|address| device.entry(address).is_some());
            let is_told = is_known(versions.old) || is_known(versions.new);
            let kind = match (old.data_type, new.data_type) {
                (Some(_), Some(_)) => &kinds::CHANGED_TYPE,
                _ => &kinds::RESPELT_TYPE,
            };
            (!is_told).then(|| kind.into())
        }
        _ => None,
    }
}

fn restricted(is_restricted: bool) -> &'static Kind {
    if is_restricted { &kinds::RESTRICTED_PDO } else { &kinds::LOOSENED_PDO }
}
