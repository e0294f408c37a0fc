//! The vendor's own numbering of the dictionary.

use super::context::Context;
use crate::model::{AxisGroup, Coordinates, Group, Index};
use crate::raw::{RawCoordinates, RawGroup};
use crate::source::{Origin, keys};

/// How the vendor's parameters lie in the dictionary.
pub(super) fn coordinates(context: &mut Context<'_>, raw: RawCoordinates) -> Coordinates {
    let RawCoordinates { key: _, base, group_size, element_shift, groups, about, source, origin } = raw;
    let groups = groups.iter().map(|(letter, raw)| group(context, letter, raw, &origin)).collect();
    Coordinates { base: Index(base), group_size, element_shift, groups, about, source, origin }
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
                let known: Vec<String> = context.axes.iter().map(|axis| axis.name.clone()).collect();
                let expected = format!("an axis of {}", keys::some(&known));
                context.invalid(name, &expected, origin.key(&path));
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
