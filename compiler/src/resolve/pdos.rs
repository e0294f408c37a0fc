//! PDOs on each axis, laid out bit by bit.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use super::context::Context;
use super::{mapped, names};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Direction, Index, Object, Pdo, Repeated};
use crate::raw::RawPdo;
use crate::source::Origin;

/// The PDOs of a direction, by index.
fn pdos(context: &mut Context<'_>, raw: &[RawPdo], direction: Direction, objects: &[Object]) -> Vec<Pdo> {
    let described: Described =
        raw.iter().filter_map(|it| Some((names::index(&it.key)?, it.per_axis))).collect();
    let mut pdos = Vec::new();
    for entity in raw {
        let at = entity.origin.header();
        let Some(index) = names::index(&entity.key).filter(|index| PDOS.contains(&index.0)) else {
            context.invalid(&entity.key, expected(direction), at);
            continue;
        };
        if let Some(fault) = beyond(context, entity, index, direction) {
            context.diagnostics.push(fault);
            continue;
        }
        for (axis, index) in copies(context, entity, index) {
            pdos.push(pdo(context, entity, (index, axis), direction, &described, objects));
        }
    }
    pdos.sort_by_key(|pdo| pdo.index);
    pdos
}

/// The PDOs of both directions.
pub(super) fn of_both_ways(
    context: &mut Context<'_>,
    [received, sent]: [&[RawPdo]; 2],
    objects: &[Object],
) -> Vec<Pdo> {
    let mut all = pdos(context, received, Direction::Rx, objects);
    all.extend(pdos(context, sent, Direction::Tx, objects));
    report_duplicates(context, &all);
    all
}

/// The indices of all PDOs: of their mapping objects, which follow from them.
pub(super) fn indices(context: &Context<'_>, pdos: [&[RawPdo]; 2]) -> BTreeSet<Index> {
    let described = pdos.into_iter().flatten().filter_map(|it| Some((it, names::index(&it.key)?)));
    described.flat_map(|(it, index)| copies(context, it, index)).map(|(_, index)| index).collect()
}

/// Where mapping objects can lie. Which part of it is for which direction is for a rule to say.
const PDOS: RangeInclusive<u16> = 0x1600..=0x1BFF;

/// Why the last axis can have no copy of a PDO, if it cannot.
fn beyond(context: &Context<'_>, entity: &RawPdo, index: Index, direction: Direction) -> Option<Diagnostic> {
    let others = context.axes.last().filter(|_| entity.per_axis)?.number;
    let last = u32::from(index.0) + u32::from(context.pdo_shift) * u32::from(others);
    let own = direction.indices();
    let end = if own.contains(&index.0) { *own.end() } else { *PDOS.end() };
    (last > u32::from(end)).then(|| {
        let message = format!("PDO {index} would be 0x{last:X} on the last axis");
        let label = format!("PDOs of this direction end at {}", Index(end));
        let fault = Diagnostic::new(&faults::COLLIDING_AXES, message, entity.origin.header(), label);
        fault.note(format!("`pdo-shift` puts the PDOs of the axes 0x{:X} apart", context.pdo_shift))
    })
}

fn expected(direction: Direction) -> &'static str {
    match direction {
        Direction::Rx => "the index of a receive PDO, 0x1600 to 0x17FF",
        Direction::Tx => "the index of a transmit PDO, 0x1A00 to 0x1BFF",
    }
}

/// The axes that have a copy of a PDO, with its index there.
pub(super) fn copies(context: &Context<'_>, entity: &RawPdo, index: Index) -> Vec<(Option<u8>, Index)> {
    if !entity.per_axis {
        return vec![(None, index)];
    }
    let axes = context.axes.iter().map(|axis| axis.number);
    axes.map(|axis| (Some(axis), context.pdo_on(index, axis))).collect()
}

/// The PDOs that each axis has, by that of the first.
pub(super) fn of_axes(raw: &[RawPdo]) -> impl Iterator<Item = Index> {
    raw.iter().filter(|pdo| pdo.per_axis).filter_map(|pdo| names::index(&pdo.key))
}

/// The PDOs that a reference names: the PDO of the first axis stands for those of all axes.
pub(super) fn named<'p>(pdos: &'p [Pdo], text: &str) -> Vec<&'p Pdo> {
    let index = names::index(text);
    let Some(named) = pdos.iter().find(|pdo| Some(pdo.index) == index) else { return Vec::new() };
    // One that is not the first axis' stands for itself.
    let meant = |pdo: &&Pdo| pdo.index == named.index || named.is_leading() && pdo.leading == named.index;
    pdos.iter().filter(meant).collect()
}

fn report_duplicates(context: &mut Context<'_>, pdos: &[Pdo]) {
    let mut known: BTreeMap<Index, &Pdo> = BTreeMap::new();
    for pdo in pdos {
        let Some(first) = known.insert(pdo.index, pdo) else { continue };
        let message = format!("there are two PDOs {}", pdo.index);
        let fault = Diagnostic::new(&faults::DUPLICATE_INDEX, message, pdo.origin.header(), "here");
        context.diagnostics.push(fault.label(first.origin.header(), "and here"));
    }
}

fn pdo(
    context: &mut Context<'_>,
    entity: &RawPdo,
    (index, axis): (Index, Option<u8>),
    direction: Direction,
    described: &Described,
    objects: &[Object],
) -> Pdo {
    let RawPdo {
        key,
        name,
        names,
        per_axis: _,
        entries,
        fixed,
        mandatory,
        excludes,
        mode,
        total,
        max_bytes,
        max_entries,
        sync_unit,
        r#virtual,
        oversampling,
        about,
        source,
        origin,
    } = entity;
    let distance = index.0.wrapping_sub(names::index(key).map_or(index.0, |index| index.0));
    Pdo {
        index,
        leading: names::index(key).unwrap_or(index),
        direction,
        name: name.clone(),
        names: names.clone(),
        axis,
        entries: mapped::mapped(context, entries, origin, "entries", axis, objects),
        fixed: fixed.unwrap_or(true),
        mandatory: *mandatory,
        excludes: self::excludes(context, excludes, origin, distance, described),
        mode: *mode,
        total: *total,
        max_bytes: *max_bytes,
        max_entries: *max_entries,
        sync_unit: sync_unit.clone(),
        r#virtual: *r#virtual,
        oversampling: *oversampling,
        about: about.clone(),
        source: source.clone(),
        origin: origin.clone(),
    }
}

/// The PDOs of a direction as they are described, each with whether every axis has one.
type Described = BTreeMap<Index, bool>;

/// What a PDO excludes: of a PDO that each axis has, that of its own axis.
fn excludes(
    context: &mut Context<'_>,
    raw: &[String],
    origin: &Origin,
    distance: u16,
    described: &Described,
) -> Vec<Index> {
    let mut excludes = Vec::new();
    for (i, text) in raw.iter().enumerate() {
        let found = names::index(text).and_then(|index| Some((index, *described.get(&index)?)));
        match found {
            Some((index, true)) => excludes.push(Index(index.0.wrapping_add(distance))),
            Some((index, false)) => excludes.push(index),
            None => {
                let at = origin.value(&format!("excludes.{i}"));
                context.no_described_pdo(text, at, "not a PDO of this direction");
            }
        }
    }
    excludes.sort();
    excludes
}
