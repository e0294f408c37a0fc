//! One of several entries that are described together.

use std::sync::Arc;

use super::Step;
use crate::model::Place;
use crate::source::{Key, Member, Table, Value, keys};

/// The path to an entry alone: where its table describes others, too, it gets one of its own.
pub(super) fn apart(tree: &mut Table, mut path: Vec<Step>, place: &Place) -> Vec<Step> {
    let Some((subindex, _)) = place.subindex else { return path };
    let entries = path.iter().position(|step| *step == Step::Key("entries".to_owned()));
    let Some((entries, Some(Step::Key(key)))) = entries.map(|at| (at, path.get(at + 1))) else { return path };
    let Some(range) = keys::range::<u8>(key).filter(|range| range.start() != range.end()) else {
        return path;
    };
    let Some(table) = path.get(..=entries).and_then(|path| table_at(tree, path)) else { return path };
    let Some(at) = table.position(key) else { return path };
    let Some(all) = table.members.remove(at) else { return path };
    let (before, after) = (subindex.checked_sub(1), subindex.checked_add(1));
    let parts = [
        before.map(|before| (*range.start(), before)),
        Some((subindex, subindex)),
        after.map(|after| (after, *range.end())),
    ];
    let parts = parts.into_iter().flatten().filter(|(first, last)| first <= last);
    table.members.extend(parts.map(|(first, last)| Member {
        key: Key::new(&format!("{first}..={last}"), all.key.at),
        ..all.clone()
    }));
    if let Some(step) = path.get_mut(entries + 1) {
        *step = Step::Key(format!("{subindex}..={subindex}"));
    }
    path
}

fn table_at<'t>(tree: &'t mut Table, path: &[Step]) -> Option<&'t mut Table> {
    let Some((Step::Key(key), rest)) = path.split_first() else { return Some(tree) };
    let place = tree.position(key)?;
    match &mut tree.members.get_mut(place)?.node.value {
        Value::Table(table) => table_at(Arc::make_mut(table), rest),
        _ => None,
    }
}
