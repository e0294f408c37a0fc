//! How much a description makes when it is written out: ranges of subindices, and all axes.

#[cfg(test)]
mod tests;

use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::model::Index;
use crate::raw::{RawAxes, RawConfiguration, RawDevice, RawEntries, RawEntry, RawObject, RawPdo};
use crate::source::{Location, keys};

/// How many entries the devices of a description may have together: more than any drive has, and few enough to be held
/// in memory. A few lines can ask for many more.
const ENTRIES: usize = 200_000;

/// How many bytes of text count as another entry.
const LONG: usize = 1 << 10;

/// What is left of the entries that a description may have.
pub(super) struct Room(usize);

impl Room {
    /// The room for a whole description.
    pub(super) fn new() -> Self {
        Self(ENTRIES)
    }

    /// Takes the room for a device, or reports that it is not there.
    pub(super) fn take(&mut self, raw: &RawDevice, diagnostics: &mut Diagnostics) -> bool {
        let axes = Axes::new(raw.axes.as_ref());
        let beyond = parts(raw, &axes).find(|(count, _)| match self.0.checked_sub(*count) {
            Some(left) => {
                self.0 = left;
                false
            }
            None => true,
        });
        let Some((_, at)) = beyond else { return true };
        let message = format!("the description has more than the {ENTRIES} entries that devc holds");
        let fault = Diagnostic::new(&faults::EXCEEDED_LIMIT, message, at, "too much with what stands before")
            .note("a range of subindices counts for all of them, and each KiB of text as another entry");
        diagnostics.push(match axes.count {
            0 | 1 => fault,
            count => fault.note(format!("what an axis has counts {count} times, once for each axis")),
        });
        false
    }
}

/// How often something is there.
struct Axes {
    count: usize,
    /// The ranges that each axis has.
    shifts: Vec<(u16, u16)>,
}

impl Axes {
    fn new(raw: Option<&RawAxes>) -> Self {
        let ranges = raw.into_iter().flat_map(|axes| &axes.shifts);
        let shifts =
            ranges.filter_map(|shift| keys::range::<u16>(&shift.range)).map(|it| (*it.start(), *it.end()));
        Self { count: raw.map_or(1, |axes| axes.names.len().clamp(1, 256)), shifts: shifts.collect() }
    }

    /// How many objects there are for one that is described.
    fn of(&self, index: Index) -> usize {
        let shifted = self.shifts.iter().any(|(first, last)| (first..=last).contains(&&index.0));
        if shifted { self.count } else { 1 }
    }
}

/// What counts, with its place.
fn parts(raw: &RawDevice, axes: &Axes) -> impl Iterator<Item = (usize, Location)> {
    let objects = raw.objects.iter().map(|entity| {
        let variants = entity.per_axis.iter().map(|(_, entity)| object(entity, axes));
        let count = variants.fold(object(entity, axes), usize::max);
        (count.saturating_mul(axes.of(entity.index)), entity.origin.header())
    });
    let pdos =
        raw.rx_pdos.iter().chain(&raw.tx_pdos).map(|entity| (pdo(entity, axes), entity.origin.header()));
    let shared = raw.rx_pdos.iter().chain(&raw.tx_pdos).any(|pdo| pdo.per_axis);
    let copies = if shared { axes.count } else { 1 };
    let configurations =
        raw.configurations.iter().map(move |entity| (copies * configuration(entity), entity.origin.header()));
    let units = raw.units.iter().filter(|unit| !unit.per_axis.is_empty());
    let units = units.map(|unit| (axes.count * (1 + unit.origin.weight() / LONG), unit.origin.header()));
    objects.chain(pdos).chain(configurations).chain(units)
}

/// An object on one axis: its entries, what is said of each, and what it reaches on other axes by triggers.
fn object(entity: &RawObject, axes: &Axes) -> usize {
    let others = axes.count - axes.of(entity.index);
    let reached = |value: &RawEntry| {
        let references =
            value.trigger.as_ref().map_or(0, |trigger| trigger.uses.len() + trigger.updates.len());
        references.saturating_mul(others)
    };
    let entry = |entry: &RawEntries| {
        let (first, last) = entry.range;
        let count = usize::from(last.saturating_sub(first)) + 1;
        count.saturating_mul(1 + entry.origin.weight() / LONG + reached(&entry.value))
    };
    let whole = 1 + entity.origin.weight() / LONG + reached(&entity.value);
    entity.entries.iter().map(entry).fold(whole, usize::saturating_add)
}

fn pdo(entity: &RawPdo, axes: &Axes) -> usize {
    let copies = if entity.per_axis { axes.count } else { 1 };
    copies * (entity.entries.len() + entity.excludes.len() + entity.origin.weight() / LONG)
}

fn configuration(entity: &RawConfiguration) -> usize {
    let RawConfiguration { outputs, inputs, mapping, .. } = entity;
    let assigned = [outputs, inputs].into_iter().flatten().map(Vec::len);
    assigned.chain(mapping.values().map(Vec::len)).sum()
}
