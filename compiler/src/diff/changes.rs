//! All changes from one version of a family to the next.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use super::change::{Change, Class, Kind};
use super::judge::{Judged, judge};
use super::kinds;
use super::place::{Versions, place};
use crate::model::{Device, Difference, Family, Place, Repeated, Section, differences};

/// What changes from one version of a family to the next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Comparison {
    /// The devices of both versions, in the order of the new one, and then those that are gone.
    pub devices: Vec<Versioned>,
    /// The changes: the worst first, and those of a class by place. What changes alike in several devices is there once.
    pub changes: Vec<Change>,
}

/// A device of one version or both.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Versioned {
    /// What it is called.
    pub name: String,
    /// Its revision number before and after; none if it is there in one version only.
    pub revisions: Option<(u32, u32)>,
}

impl Comparison {
    /// The worst class of all changes; none if nothing changes.
    pub fn worst(&self) -> Option<Class> {
        self.changes.iter().map(|change| change.kind.class).max()
    }

    /// The changes of a device, by its number.
    pub fn of(&self, device: usize) -> impl Iterator<Item = &Change> {
        self.changes.iter().filter(move |change| change.devices.contains(&device))
    }
}

/// Compares two versions of a family. Two that are alone are one device, whatever they are called; the members of others
/// are told apart by their ids.
pub fn compare(old: &Family, new: &Family) -> Comparison {
    let mut devices = Vec::new();
    let mut all: BTreeMap<Key, Change> = BTreeMap::new();
    let mut add = |number: usize, changes: Vec<Change>| {
        for change in changes {
            all.entry(key(&change)).or_insert(change).devices.push(number);
        }
    };
    for (number, member) in new.members.iter().enumerate() {
        let before = before(old, new, member);
        let revisions = before.map(|before| (before.identity.revision, member.identity.revision));
        devices.push(Versioned { name: member.name.clone(), revisions });
        add(
            number,
            match before {
                Some(before) => versions(Versions { old: before, new: member }),
                None => vec![alone(member, &kinds::ADDED_DEVICE)],
            },
        );
    }
    for member in old.members.iter().filter(|member| before(new, old, member).is_none()) {
        add(devices.len(), vec![alone(member, &kinds::REMOVED_DEVICE)]);
        devices.push(Versioned { name: member.name.clone(), revisions: None });
    }
    let mut changes: Vec<Change> = all.into_values().collect();
    let everywhere: Vec<usize> = (0..devices.len()).collect();
    changes.extend(family(old, new).map(|change| Change { devices: everywhere.clone(), ..change }));
    changes.sort_by(order);
    Comparison { devices, changes }
}

/// The device of another version that a member is a version of.
fn before<'f>(other: &'f Family, own: &Family, member: &Device) -> Option<&'f Device> {
    match (other.members.as_slice(), own.members.as_slice()) {
        ([one], [_]) => Some(one),
        (members, _) => members.iter().find(|other| other.id == member.id),
    }
}

fn alone(device: &Device, kind: &'static Kind) -> Change {
    let is_gone = kind.class == Class::WireBreaking;
    let name = Some(device.name.clone());
    let at = Some(device.origin.header());
    Change {
        old: name.clone().filter(|_| is_gone),
        new: name.filter(|_| !is_gone),
        old_at: at.filter(|_| is_gone),
        new_at: at.filter(|_| !is_gone),
        ..Change::new(kind, Place::default())
    }
}

/// What a family says of itself, unless it is a device that says it.
fn family<'f>(old: &'f Family, new: &'f Family) -> impl Iterator<Item = Change> + use<'f> {
    let differ = differences(old, new).into_iter().filter(|difference| difference.path.0.len() == 1);
    let is_device = |family: &Family| matches!(family.members.as_slice(), [only] if only.name == family.name);
    let of_device = is_device(old) && is_device(new);
    let is_own = move |difference: &Difference| match difference.path.0.first().map(|field| &**field) {
        Some("name") => !of_device,
        Some("about" | "source") => true,
        _ => difference.is_order,
    };
    differ.filter(is_own).map(|difference| {
        let key = difference.path.0.first().cloned().unwrap_or_default();
        let kind = if difference.is_order { &kinds::REORDERED } else { &kinds::CHANGED_TEXT };
        Change { name: None, ..Change::of(kind, Section::Family.at(key), &difference) }
    })
}

fn versions(versions: Versions<'_>) -> Vec<Change> {
    let mut found: BTreeMap<Key, (Change, BTreeSet<Option<u8>>)> = BTreeMap::new();
    for difference in differences(versions.old, versions.new) {
        let path: Vec<&str> = difference.path.0.iter().map(|step| &**step).collect();
        let Some(change) = change(versions, &path, &difference) else { continue };
        let (_, axes) = found.entry(key(&change)).or_insert_with(|| (change, BTreeSet::new()));
        axes.insert(versions.repeated(&path).and_then(Repeated::axis));
    }
    found.into_values().map(|(change, axes)| Change { axes: axes.len(), ..change }).collect()
}

/// What makes changes on several axes, and in several devices, one.
type Key = (&'static str, Place, Option<String>, Option<String>);

fn key(change: &Change) -> Key {
    let Change { kind, at, name, old, new, .. } = change;
    // what comes or goes as a whole is shown by its name, which may be another one on each axis
    let is_whole = (old.is_none() || new.is_none()) && old.as_ref().or(new.as_ref()) == name.as_ref();
    let [old, new] = [old, new].map(|text| text.clone().filter(|_| !is_whole));
    (kind.rule.name, at.clone(), old, new)
}

/// The change that a difference is; none if it follows from another one.
fn change(versions: Versions<'_>, path: &[&str], difference: &Difference) -> Option<Change> {
    let Judged { kind, of_whole } = judge(versions, path, difference)?;
    let path = path.get(..of_whole.as_ref().map_or(path.len(), |whole| whole.depth)).unwrap_or(path);
    let at = place(path);
    let at = match versions.repeated(path) {
        Some(one) => Place { key: Place::from(one.leading()).key, ..at },
        None => at,
    };
    let change = Change { name: versions.name(path), ..Change::of(kind, at, difference) };
    Some(match of_whole {
        Some(whole) => Change { old: Some(whole.old), new: Some(whole.new), ..change },
        None => change,
    })
}

/// The worst first, then by place.
fn order(one: &Change, other: &Change) -> Ordering {
    let worse = other.kind.class.cmp(&one.kind.class);
    worse.then_with(|| one.at.cmp(&other.at)).then_with(|| one.kind.rule.name.cmp(other.kind.rule.name))
}
