//! The described part of the dictionary.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use super::context::Context;
use super::{entries, names, numbered};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Index, Kind, Object};
use crate::raw::{RawObject, RawObjectHead};
use crate::source::{Location, keys};

/// What description says of objects that devc makes, by index.
pub(super) struct Described {
    pub(super) objects: Vec<Object>,
    pub(super) overlays: Vec<RawObject>,
}

/// Resolves each described object on each axis; sets aside what is said of objects that devc makes. What lies among the
/// mapping objects, as PDO parameters do, and belongs to none of the `pdos` is an object as any other.
pub(super) fn objects(context: &mut Context<'_>, raw: Vec<RawObject>, pdos: &BTreeSet<Index>) -> Described {
    let mut described = Described { objects: Vec::new(), overlays: Vec::new() };
    for entity in raw {
        let index = entity.index;
        if index.is_derived() && (index >= Index(0x1C00) || pdos.contains(&index)) {
            described.overlays.push(entity);
            continue;
        }
        let differing = differing(context, &entity);
        for (axis, by) in context.copies(index) {
            let entity = on_axis(&differing, axis).unwrap_or(&entity);
            described.objects.extend(object(context, entity, Index(index.0 + by), axis));
        }
    }
    described.objects.sort_by_key(|object| object.index);
    report_duplicates(context, &described.objects);
    described
}

/// The object of this index, among objects in the order of their indices.
pub(super) fn at(objects: &[Object], index: Index) -> Option<&Object> {
    let place = objects.binary_search_by_key(&index, |object| object.index).ok()?;
    objects.get(place)
}

/// The object as it is on some axes; reports what names no axis, or one that others name, and what is said of axes that do not
/// have one each.
fn differing<'e>(
    context: &mut Context<'_>,
    entity: &'e RawObject,
) -> Vec<(RangeInclusive<usize>, &'e RawObject)> {
    if entity.per_axis.is_empty() {
        return Vec::new();
    }
    if context.copies(entity.index) == [(None, 0)] {
        let message = format!("{} is there once, and differs from axis to axis", entity.index);
        let at = entity.origin.value("per-axis");
        let fault = Diagnostic::new(&faults::INVALID_VALUE, message, at, "no axis has one of its own");
        context
            .diagnostics
            .push(fault.help("widen a range of `shifts` in `[axes]`, or say it of the object"));
    }
    let known: Vec<String> = context.axes.iter().map(|axis| axis.name.clone()).collect();
    let mut differing: Vec<(RangeInclusive<usize>, &RawObject)> = Vec::new();
    let mut places: Vec<Location> = Vec::new();
    for (axes, on_them) in &entity.per_axis {
        let at = entity.origin.key(&format!("per-axis.{axes}"));
        let Some(range) = keys::names(axes, &known) else {
            context.invalid(axes, &format!("an axis or a range of axes of {}", keys::some(&known)), at);
            continue;
        };
        let is_shared = |(other, _): &(RangeInclusive<usize>, _)| {
            other.start() <= range.end() && range.start() <= other.end()
        };
        if let Some(other) = differing.iter().position(is_shared).and_then(|place| places.get(place)) {
            let message = format!("{} is said to differ twice on one axis", entity.index);
            let fault = Diagnostic::new(&faults::DUPLICATE_DEFINITION, message, at, "here");
            context.diagnostics.push(fault.label(*other, "and here"));
        }
        differing.push((range, on_them));
        places.push(at);
    }
    differing
}

/// The object as it is on an axis, if it is another one there.
fn on_axis<'e>(
    differing: &[(RangeInclusive<usize>, &'e RawObject)],
    axis: Option<u8>,
) -> Option<&'e RawObject> {
    let axis = usize::from(axis?);
    differing.iter().find(|(axes, _)| axes.contains(&axis)).map(|(_, entity)| *entity)
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

/// An object on an axis.
pub(super) fn object(
    context: &mut Context<'_>,
    raw: &RawObject,
    index: Index,
    axis: Option<u8>,
) -> Option<Object> {
    let RawObject { key, index: _, head, value, entries, shared: _, per_axis: _, source, origin } = raw;
    let RawObjectHead { id: _, kind, entries: _, sdo_access, per_axis: _ } = head;
    let id = names::object_id(raw);
    let name = value.name.clone().unwrap_or_else(|| id.clone());
    let is_single = entries.is_empty() && kind.is_none_or(|kind| kind == Kind::Var);
    let mut entries = match is_single {
        true => vec![entries::single(context, raw, index, &name)?],
        false => entries::several(context, raw, index)?,
    };
    for trigger in entries.iter_mut().filter_map(|entry| entry.trigger.as_mut()) {
        for addresses in [&mut trigger.uses, &mut trigger.updates] {
            *addresses = addresses.iter().flat_map(|address| context.reached(*address, axis)).collect();
        }
    }
    Some(Object {
        index,
        leading: raw.index,
        id,
        name,
        names: value.names.clone(),
        kind: kind.unwrap_or_else(|| self::kind(raw)),
        axis,
        category: value.category.unwrap_or_default(),
        about: value.about.clone(),
        note: value.note.clone(),
        functional: value.functional.unwrap_or(true),
        parameter: whole(value.parameter.as_ref()).or_else(|| coordinate(context, key)),
        properties: value.properties.clone(),
        sdo_access: *sdo_access,
        entries,
        derived: false,
        source: source.clone(),
        // what differs on other axes is said of the objects there
        origin: origin.without("per-axis"),
    })
}

/// The parameter behind an object; one with a number in braces is behind each of its entries.
fn whole(parameter: Option<&String>) -> Option<String> {
    parameter.filter(|parameter| numbered::numbered(parameter, 1).is_none()).cloned()
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
