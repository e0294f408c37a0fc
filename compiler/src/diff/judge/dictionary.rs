//! Objects.

use super::{Presence, entry, function, presence};
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::{Versions, address, index};
use crate::model::{Device, Difference, Index};

/// The identity object.
const IDENTITY: Index = Index(0x1018);

/// The number of entries stands in subindex 0.
const COUNT: u8 = 0;

/// What an object and its only value have in common.
const OF_THE_OBJECT: [&str; 10] =
    ["name", "names", "id", "functional", "category", "about", "note", "parameter", "properties", "source"];

pub(super) fn judge(versions: Versions<'_>, path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    let (key, rest) = path.split_first()?;
    if follows(versions, index(key)?, rest) {
        return None;
    }
    Some(match rest {
        [] => match presence(difference) {
            Presence::Gone => &kinds::REMOVED_OBJECT,
            _ => &kinds::ADDED_OBJECT,
        },
        ["kind"] => &kinds::CHANGED_KIND,
        ["name"] => &kinds::RENAMED,
        // The word follows from the name, unless it is chosen.
        ["id"] => {
            return versions.object(key).filter(|(old, new)| old.name == new.name).map(|_| &kinds::RENAMED);
        }
        ["functional"] => function(difference),
        // Said of no way of transfer, both are allowed.
        ["sdo_access"] if presence(difference).is_gone() => &kinds::WIDENED_ACCESS,
        ["sdo_access"] => &kinds::NARROWED_ACCESS,
        ["entries", address, rest @ ..] => return of_entry(versions, key, address, rest, difference),
        // They follow from how the axes are arranged, and from what PDOs there are.
        ["leading" | "axis" | "derived"] => return None,
        _ => &kinds::CHANGED_TEXT,
    })
}

/// Whether it says again what is said elsewhere: the objects of PDOs and sync managers, and the identity.
fn follows(versions: Versions<'_>, index: Index, path: &[&str]) -> bool {
    let of = |device: &Device| device.object(index).is_none_or(|object| object.derived);
    let is_derived = of(versions.old) && of(versions.new);
    let is_there = versions.old.object(index).is_some() && versions.new.object(index).is_some();
    match path {
        // One that comes to follow from a PDO, or no longer does: the PDO is what is new or gone.
        _ if is_there && of(versions.old) != of(versions.new) => true,
        [] | ["kind"] | ["entries", _] => is_derived,
        ["entries", _, "default"] => is_derived || is_identity(versions, index),
        ["entries", _, "access"] => is_derived && versions.old.mailbox != versions.new.mailbox,
        _ => false,
    }
}

fn is_identity(versions: Versions<'_>, index: Index) -> bool {
    index == IDENTITY && versions.old.identity != versions.new.identity
}

fn of_entry(
    versions: Versions<'_>,
    object: &str,
    key: &str,
    rest: &[&str],
    difference: &Difference,
) -> Option<&'static Kind> {
    // With the kind of an object all its entries are others.
    let (old, new) = versions.object(object)?;
    if old.kind != new.kind {
        return None;
    }
    let is_count = address(key)?.subindex == COUNT && old.entries.len() > 1;
    if is_count && old.entries.len() != new.entries.len() {
        return None;
    }
    // What an object with one value says of itself it says of the value.
    if new.kind == crate::model::Kind::Var && rest.first().is_some_and(|field| OF_THE_OBJECT.contains(field))
    {
        return None;
    }
    match (rest, presence(difference)) {
        ([], Presence::Gone) => Some(&kinds::REMOVED_ENTRY),
        ([], _) => Some(&kinds::ADDED_ENTRY),
        (rest, _) => entry::judge(versions, key, rest, difference),
    }
}
