//! The described part of the dictionary.

use super::context::Context;
use super::{entries, facts, keys, names};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Category, Index, Kind, Object};
use crate::raw::{ObjectEntity, RawCategory, RawKind};

/// What description says of objects that devc makes, by index.
pub(super) struct Described {
    pub(super) objects: Vec<Object>,
    pub(super) overlays: Vec<(Index, ObjectEntity)>,
}

/// How many entries a dictionary may have: more than any drive has, and few enough to be held in memory. A few lines
/// of a description can ask for many more, by ranges of subindices and by axes.
const MOST_ENTRIES: usize = 500_000;

/// Resolves each described object on each axis; sets aside what is said of objects that devc makes.
pub(super) fn objects(context: &mut Context<'_>, raw: Vec<ObjectEntity>) -> Described {
    let mut described = Described { objects: Vec::new(), overlays: Vec::new() };
    for entity in within_limit(context, raw) {
        let at = entity.object.origin.header();
        let Some(index) = context.names.key(&entity.object.key) else {
            context.invalid(&entity.object.key, "an index such as 0x6040", at);
            continue;
        };
        if is_made(index) {
            described.overlays.push((index, entity));
            continue;
        }
        report_unknown_axes(context, &entity);
        for (axis, by) in context.copies(index) {
            let entity = on_axis(context, &entity, axis);
            described.objects.extend(object(context, entity, Index(index.0 + by), axis));
        }
    }
    described.objects.sort_by_key(|object| object.index);
    report_duplicates(context, &described.objects);
    described
}

/// The objects, or none if they would have too many entries on all axes together.
fn within_limit(context: &mut Context<'_>, raw: Vec<ObjectEntity>) -> Vec<ObjectEntity> {
    let mut total = 0;
    let excess = raw.iter().find(|entity| {
        let index = context.names.key(&entity.object.key);
        let copies = index.map_or(0, |index| context.copies(index).len());
        let ranges = entity.entries.iter().filter_map(|entry| keys::range::<u8>(&entry.key));
        total += copies * (1 + ranges.map(Iterator::count).sum::<usize>());
        total > MOST_ENTRIES
    });
    let Some(at) = excess.map(|entity| entity.object.origin.header()) else { return raw };
    let message = format!("the dictionary has more than the {MOST_ENTRIES} entries that devc holds");
    let fault = Diagnostic::new(&faults::UNFIT_VALUE, message, at, "too much with what stands before");
    context.diagnostics.push(match context.axes.len() {
        0 | 1 => fault,
        axes => fault.note(format!("an object of an axis counts {axes} times, once for each axis")),
    });
    Vec::new()
}

/// The object of this index, among objects in the order of their indices.
pub(super) fn at(objects: &[Object], index: Index) -> Option<&Object> {
    let place = objects.binary_search_by_key(&index, |object| object.index).ok()?;
    objects.get(place)
}

/// Whether devc makes the object from PDOs and sync managers.
fn is_made(index: Index) -> bool {
    matches!(index.0, 0x1600..=0x17FF | 0x1A00..=0x1C00 | 0x1C10..=0x1C13)
}

/// The object as it is on an axis.
fn on_axis<'e>(context: &Context<'_>, entity: &'e ObjectEntity, axis: Option<u8>) -> &'e ObjectEntity {
    let Some(axis) = axis else { return entity };
    let known = axis_names(context);
    let differing = entity
        .per_axis
        .iter()
        .find(|(axes, _)| keys::names(axes, &known).is_some_and(|range| range.contains(&usize::from(axis))));
    differing.map_or(entity, |(_, entity)| entity)
}

fn axis_names(context: &Context<'_>) -> Vec<String> {
    context.axes.iter().map(|axis| axis.name.clone()).collect()
}

fn report_unknown_axes(context: &mut Context<'_>, entity: &ObjectEntity) {
    let known = axis_names(context);
    for (axes, _) in &entity.per_axis {
        if keys::names(axes, &known).is_none() {
            let at = entity.object.origin.value("per-axis");
            context.invalid(axes, &format!("an axis or a range of axes of {}", known.join(", ")), at);
        }
    }
}

fn report_duplicates(context: &mut Context<'_>, objects: &[Object]) {
    for pair in objects.windows(2) {
        if let [first, second] = pair
            && first.index == second.index
        {
            let message = format!("{} is described twice", second.index);
            let fault = Diagnostic::new(&faults::DUPLICATE_INDEX, message, second.origin.header(), "here");
            context.diagnostics.push(fault.label(first.origin.header(), "and here"));
        }
    }
}

fn object(
    context: &mut Context<'_>,
    entity: &ObjectEntity,
    index: Index,
    axis: Option<u8>,
) -> Option<Object> {
    let ObjectEntity { object, value, entries: raw_entries, per_axis: _ } = entity;
    let id = names::object_id(entity);
    let name = value.name.clone().unwrap_or_else(|| id.clone());
    let entries = if raw_entries.is_empty() && object.raw.kind.is_none_or(|kind| kind == RawKind::Var) {
        vec![entries::single(context, entity, index, &name)?]
    } else {
        entries::several(context, entity, index)?
    };
    Some(Object {
        index,
        id,
        name,
        kind: kind(entity),
        axis,
        category: category(value.category),
        about: value.about.clone(),
        note: value.note.clone(),
        functional: value.functional.unwrap_or(true),
        parameter: value.parameter.clone().or_else(|| coordinate(context, &object.key)),
        entries,
        provenance: context.provenance(&object.origin, "name"),
        source: facts::source(context, &object.facts),
        origin: object.origin.clone(),
    })
}

/// The coordinate that the object is described under, if it is not under its index.
fn coordinate(context: &Context<'_>, key: &str) -> Option<String> {
    context.names.coordinate(key).map(|_| key.to_owned())
}

/// What the object is made of, as written or as its entries look.
fn kind(entity: &ObjectEntity) -> Kind {
    match entity.object.raw.kind {
        Some(RawKind::Var) => Kind::Var,
        Some(RawKind::Array) => Kind::Array,
        Some(RawKind::Record) => Kind::Record,
        None if entity.entries.is_empty() => Kind::Var,
        None if entity.entries.iter().any(|entry| entry.key.contains("..=")) => Kind::Array,
        None => Kind::Record,
    }
}

pub(super) fn category(raw: Option<RawCategory>) -> Category {
    match raw {
        Some(RawCategory::Mandatory) => Category::Mandatory,
        Some(RawCategory::Conditional) => Category::Conditional,
        Some(RawCategory::Optional) | None => Category::Optional,
    }
}
