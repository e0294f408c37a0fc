//! The described part of the dictionary.

use super::context::Context;
use super::{entries, names};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Index, Kind, Object};
use crate::raw::{RawObject, RawObjectHead};
use crate::source::keys;

/// What description says of objects that devc makes, by index.
pub(super) struct Described {
    pub(super) objects: Vec<Object>,
    pub(super) overlays: Vec<RawObject>,
}

/// How many entries a dictionary may have: more than any drive has, and few enough to be held in memory. A few lines
/// of a description can ask for many more, by ranges of subindices and by axes.
const MOST_ENTRIES: usize = 500_000;

/// Resolves each described object on each axis; sets aside what is said of objects that devc makes.
pub(super) fn objects(context: &mut Context<'_>, raw: Vec<RawObject>) -> Described {
    let mut described = Described { objects: Vec::new(), overlays: Vec::new() };
    for entity in within_limit(context, raw) {
        let index = entity.index;
        if index.is_derived() {
            described.overlays.push(entity);
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
fn within_limit(context: &mut Context<'_>, raw: Vec<RawObject>) -> Vec<RawObject> {
    let mut total = 0;
    let excess = raw.iter().find(|entity| {
        let several = entity.entries.iter().map(|entries| usize::from(entries.range.1 - entries.range.0) + 1);
        total += context.copies(entity.index).len() * (1 + several.sum::<usize>());
        total > MOST_ENTRIES
    });
    let Some(at) = excess.map(|entity| entity.origin.header()) else { return raw };
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

/// The object as it is on an axis.
fn on_axis<'e>(context: &Context<'_>, entity: &'e RawObject, axis: Option<u8>) -> &'e RawObject {
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

fn report_unknown_axes(context: &mut Context<'_>, entity: &RawObject) {
    let known = axis_names(context);
    for (axes, _) in &entity.per_axis {
        if keys::names(axes, &known).is_none() {
            let at = entity.origin.value("per-axis");
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

fn object(context: &mut Context<'_>, raw: &RawObject, index: Index, axis: Option<u8>) -> Option<Object> {
    let RawObject { key, index: _, head, value, entries, shared: _, per_axis: _, source, origin } = raw;
    let RawObjectHead { id: _, kind, entries: _, per_axis: _ } = head;
    let id = names::object_id(raw);
    let name = value.name.clone().unwrap_or_else(|| id.clone());
    let is_single = entries.is_empty() && kind.is_none_or(|kind| kind == Kind::Var);
    let entries = match is_single {
        true => vec![entries::single(context, raw, index, &name)?],
        false => entries::several(context, raw, index)?,
    };
    Some(Object {
        index,
        leading: raw.index,
        id,
        name,
        kind: kind.unwrap_or_else(|| self::kind(raw)),
        axis,
        category: value.category.unwrap_or_default(),
        about: value.about.clone(),
        note: value.note.clone(),
        functional: value.functional.unwrap_or(true),
        parameter: value.parameter.clone().or_else(|| coordinate(context, key)),
        entries,
        derived: false,
        source: source.clone(),
        origin: origin.clone(),
    })
}

/// The coordinate that the object is described under, if it is not under its index.
fn coordinate(context: &Context<'_>, key: &str) -> Option<String> {
    context.names.coordinate(key).map(|_| key.to_owned())
}

/// What an object is made of, by how its entries look.
fn kind(raw: &RawObject) -> Kind {
    match raw.entries.iter().any(|entries| entries.many) {
        _ if raw.entries.is_empty() => Kind::Var,
        true => Kind::Array,
        false => Kind::Record,
    }
}
