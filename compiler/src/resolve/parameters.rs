//! Settings outside the dictionary, and the vendor's own numbering of it.

use std::collections::BTreeMap;

use super::context::Context;
use super::{facts, keys};
use crate::model::{AxisGroup, Coordinates, Group, Index, Parameter, Value, ValueRange};
use crate::raw::{Entity, Literal, RawCoordinates, RawField, RawGroup, RawParameter};
use crate::source::Origin;

/// The settings, in the order in which they were written.
pub(super) fn parameters(context: &mut Context<'_>, raw: Vec<Entity<RawParameter>>) -> Vec<Parameter> {
    raw.into_iter()
        .map(|Entity { key, raw, facts, origin }| Parameter {
            address: context.names.coordinate(&key),
            id: key,
            name: raw.name,
            about: raw.about,
            default: raw.default.as_ref().map(untyped),
            min: raw.min.as_ref().map(untyped),
            max: raw.max.as_ref().map(untyped),
            symbol: raw.symbol,
            values: ranges(context, &raw.values, &origin),
            source: facts::source(context, &facts),
            origin,
        })
        .collect()
}

fn ranges(context: &mut Context<'_>, raw: &BTreeMap<String, RawField>, origin: &Origin) -> Vec<ValueRange> {
    let mut ranges = Vec::new();
    for (key, field) in raw {
        match keys::range::<i64>(key) {
            None => {
                let at = origin.value(&format!("values.{key}"));
                context.invalid(key, "a value, or a range of values such as \"1..=10\"", at);
            }
            Some(range) => ranges.push(ValueRange {
                first: *range.start(),
                last: *range.end(),
                name: field.name.clone(),
                about: field.about.clone(),
            }),
        }
    }
    ranges.sort_by_key(|range| range.first);
    ranges
}

/// A literal as it stands, where there is no type to fit it to.
pub(super) fn untyped(literal: &Literal) -> Value {
    match literal {
        Literal::Boolean(value) => Value::Boolean(*value),
        Literal::Float(value) => Value::Real(*value),
        Literal::Text(text) => Value::Text(text.clone()),
        Literal::Integer(value) => {
            i64::try_from(*value).map_or_else(|_| Value::Text(value.to_string()), Value::Integer)
        }
    }
}

/// How the vendor's parameters lie in the dictionary.
pub(super) fn coordinates(context: &mut Context<'_>, entity: &Entity<RawCoordinates>) -> Coordinates {
    let Entity { raw, facts, origin, .. } = entity;
    let groups = raw.groups.iter().map(|(letter, raw)| group(context, letter, raw, origin)).collect();
    Coordinates {
        base: Index(raw.base),
        group_size: raw.group_size,
        info_shift: raw.info_shift,
        groups,
        about: raw.about.clone(),
        source: facts::source(context, facts),
        origin: origin.clone(),
    }
}

fn group(context: &mut Context<'_>, letter: &str, raw: &RawGroup, origin: &Origin) -> Group {
    let range = raw
        .range
        .as_deref()
        .and_then(|text| indices(context, text, &format!("groups.{letter}.range"), origin));
    Group {
        letter: letter.to_owned(),
        name: raw.name.clone(),
        number: raw.number,
        range,
        per_axis: per_axis(context, letter, raw, origin),
    }
}

/// Where a group lies on the axes that are named.
fn per_axis(context: &mut Context<'_>, letter: &str, raw: &RawGroup, origin: &Origin) -> Vec<AxisGroup> {
    let mut groups = Vec::new();
    for (name, differing) in &raw.per_axis {
        let path = format!("groups.{letter}.per-axis.{name}");
        let axis = context.axes.iter().find(|axis| axis.name == *name).map(|axis| axis.number);
        let range = indices(context, &differing.range, &format!("{path}.range"), origin);
        match (axis, range) {
            (Some(axis), Some((first, last))) => groups.push(AxisGroup { axis, first, last }),
            (None, _) => {
                let known: Vec<&str> = context.axes.iter().map(|axis| axis.name.as_str()).collect();
                let expected = format!("an axis of {}", known.join(", "));
                context.invalid(name, &expected, origin.value(&path));
            }
            _ => {}
        }
    }
    groups.sort_by_key(|group| group.axis);
    groups
}

fn indices(context: &mut Context<'_>, text: &str, path: &str, origin: &Origin) -> Option<(Index, Index)> {
    let range = keys::range::<u16>(text);
    if range.is_none() {
        context.invalid(text, "a range of indices such as \"0x2000..=0x21FF\"", origin.value(path));
    }
    range.map(|range| (Index(*range.start()), Index(*range.end())))
}
