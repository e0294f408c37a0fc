//! What the axes do not share: the indices, and what differs from the first axis.

use super::overview::{access, mappable};
use crate::emit::markdown::context::{Context, is_single};
use crate::emit::markdown::inline::{code, link, text};
use crate::emit::markdown::table::Table;
use crate::model::{Entry, Object};

/// The index of each object on each axis.
pub(super) fn indices(context: &Context<'_>, objects: &[&Object]) -> Table {
    let names = context.axis_names().map(text);
    let mut table = Table::new([String::from("Object")].into_iter().chain(names));
    let own = objects.iter().filter(|object| context.has_axes() && object.axis.is_some());
    for object in own {
        let name = link(text(&object.name), context.object_id(object));
        let places = context.on_axes(object).into_iter();
        let places = places.map(|place| place.map_or_else(|| "–".into(), |object| code(object.index)));
        table.row([name].into_iter().chain(places));
    }
    table
}

/// What differs from the first axis, a line for all axes that differ alike.
pub(super) fn differences(context: &Context<'_>, leading: &Object) -> Vec<String> {
    if leading.axis.is_none() {
        return Vec::new();
    }
    let mut groups: Vec<(Vec<u8>, String)> = Vec::new();
    for (axis, object) in (0_u8..).zip(context.on_axes(leading)) {
        let text =
            object.map_or_else(|| "not there".into(), |object| compare(context, leading, object).join(", "));
        match groups.iter_mut().find(|(_, same)| *same == text) {
            Some((axes, _)) => axes.push(axis),
            None => groups.push((vec![axis], text)),
        }
    }
    let told = groups.into_iter().filter(|(_, text)| !text.is_empty());
    told.map(|(axes, text)| format!("On {}: {text}", context.axes(&axes))).collect()
}

fn compare(context: &Context<'_>, leading: &Object, object: &Object) -> Vec<String> {
    let mut changes = Vec::new();
    let changed =
        |one: &Option<String>, other: &Option<String>| if one == other { None } else { other.clone() };
    changes.extend((leading.name != object.name).then(|| format!("called {}", text(&object.name))));
    changes.extend((leading.functional && !object.functional).then(|| "no function".into()));
    changes.extend((!leading.functional && object.functional).then(|| "has a function".into()));
    changes.extend(changed(&leading.about, &object.about).map(|about| context.prose(&about)));
    changes.extend(changed(&leading.note, &object.note).map(|note| context.prose(&note)));
    for entry in &object.entries {
        let prefix = if is_single(object) {
            String::new()
        } else {
            code(format!(":{:02X}", entry.address.subindex)) + " "
        };
        let single = is_single(object);
        match leading.entry(entry.address.subindex) {
            Some(first) => changes.extend(
                compare_entries(context, first, entry, single).iter().map(|one| format!("{prefix}{one}")),
            ),
            None => changes.push(format!("{prefix}{}", text(&entry.name))),
        }
    }
    let mut told = Vec::new();
    changes.into_iter().for_each(|change| {
        if !told.contains(&change) {
            told.push(change)
        }
    });
    told
}

fn compare_entries(context: &Context<'_>, first: &Entry, entry: &Entry, single: bool) -> Vec<String> {
    let mut changes = Vec::new();
    let changed =
        |one: &Option<String>, other: &Option<String>| if one == other { None } else { other.clone() };
    changes.extend((!single && first.name != entry.name).then(|| format!("called {}", text(&entry.name))));
    changes.extend((first.functional && !entry.functional).then(|| "no function".into()));
    changes.extend((first.data_type != entry.data_type).then(|| entry.data_type.to_string()));
    changes.extend((first.access != entry.access).then(|| format!("access {}", access(entry.access))));
    changes.extend((first.pdo != entry.pdo).then(|| format!("PDO {}", mappable(entry.pdo))));
    changes.extend((first.default != entry.default).then(|| format!("default {}", context.default(entry))));
    changes.extend(
        (context.range(first) != context.range(entry)).then(|| format!("range {}", context.range(entry))),
    );
    changes.extend((first.unit != entry.unit).then(|| format!("unit {}", context.unit(entry, None))));
    changes.extend(changed(&first.about, &entry.about).map(|about| context.prose(&about)));
    changes.extend(changed(&first.note, &entry.note).map(|note| context.prose(&note)));
    changes
}
