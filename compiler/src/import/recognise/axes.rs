//! Axes that lie flat in one dictionary: their objects 0x800 apart, their PDOs 0x10 apart.
//!
//! What is the same on all axes is described for the first; what is not on all of them stays as it is.

use std::collections::{BTreeMap, BTreeSet};

use super::super::read::{Pdo, PdoEntry};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, get, set, set_some};
use super::described::Described;
use super::draft::Block;
use crate::model::Kind;

/// How far apart the objects and the PDOs of the axes are, ETG.6010.
const OBJECTS: u16 = 0x800;
const PDOS: u16 = 0x10;

/// The indices of the first axis.
const FIRST: std::ops::RangeInclusive<u16> = 0x6000..=0x67FF;

/// Axes, with what is described once for all of them.
#[derive(Debug, Default)]
pub(super) struct Axes {
    count: u16,
    /// How far apart their PDOs are.
    pdo_step: u16,
    /// What they are called.
    names: Vec<String>,
    /// Whether the file calls them so.
    are_named: bool,
    /// Objects of the first axis that all have, with what differs on others, by axis.
    shared: BTreeMap<u16, Vec<(String, Toml)>>,
    /// The first and the last index of each range in which all objects are shared.
    ranges: Vec<(u16, u16)>,
}

impl Axes {
    /// The axes of a dictionary: as many as have a control word and a status word. None if there are not several.
    pub(super) fn of(objects: &[Described], slots: &[String], pdos: [&[&Pdo]; 2]) -> Self {
        let at = |index: u16| {
            objects.binary_search_by_key(&index, |it| it.index).ok().and_then(|it| objects.get(it))
        };
        let is_word =
            |index| at(index).and_then(|it| it.values.first()).is_some_and(|it| it.data_type.bits() == 16);
        let steps = (0..8_u16).map(|axis| axis * OBJECTS);
        let count = steps.take_while(|by| is_word(0x6040 + by) && is_word(0x6041 + by)).count();
        let mut axes = Self { count: u16::try_from(count).unwrap_or(0), ..Self::default() };
        if axes.count < 2 {
            return Self::default();
        }
        let unique: BTreeSet<&String> = slots.iter().collect();
        axes.are_named = slots.len() == count && unique.len() == count;
        axes.names = if axes.are_named { slots.to_vec() } else { (0..axes.count).map(letter).collect() };
        for first in objects.iter().filter(|it| FIRST.contains(&it.index)) {
            let others = (1..axes.count)
                .map(|axis| at(first.index + axis * OBJECTS).and_then(|it| differing(first, it)));
            if let Some(others) = others.collect::<Option<Vec<Keys>>>() {
                let named = (1..).zip(others).filter(|(_, keys)| !keys.is_empty());
                let named = named.map(|(axis, keys)| (axes.name(axis), Toml::Table(keys)));
                let named: Vec<_> = named.collect();
                axes.shared.insert(first.index, named);
            }
        }
        axes.ranges = axes.ranges(objects);
        axes.pdo_step = axes.step(pdos);
        axes
    }

    /// What they are called; nothing if there are not several.
    pub(super) fn names(&self) -> &[String] {
        &self.names
    }

    /// Whether the objects and the PDOs of the axes are so far apart.
    pub(super) fn are_apart(&self, objects: u16, pdos: u16) -> bool {
        objects == OBJECTS && pdos == self.pdo_step
    }

    /// How far the PDOs are apart: the distance by which most are those of all axes, the usual one if it is one of these.
    fn step(&self, ways: [&[&Pdo]; 2]) -> u16 {
        let is_of_axis = |pdo: &&&Pdo| pdo.entries.iter().any(|it| self.shared.contains_key(&it.index));
        let distances = ways.into_iter().flat_map(|pdos| {
            let first = pdos.iter().find(is_of_axis).map(|it| it.index);
            pdos.iter().filter_map(move |it| it.index.checked_sub(first?)).filter(|it| *it > 0)
        });
        let distances: BTreeSet<u16> = distances.filter(|it| *it != PDOS).collect();
        let leading = |step: u16| ways.map(|pdos| self.leading(pdos, step).len()).iter().sum::<usize>();
        let mut best = (PDOS, leading(PDOS));
        for step in distances {
            let found = leading(step);
            if found > best.1 {
                best = (step, found);
            }
        }
        best.0
    }

    fn name(&self, axis: u16) -> String {
        self.names.get(usize::from(axis)).cloned().unwrap_or_default()
    }

    fn ranges(&self, objects: &[Described]) -> Vec<(u16, u16)> {
        let areas =
            |it: &&Described| (*FIRST.start()..FIRST.start() + self.count * OBJECTS).contains(&it.index);
        let places =
            objects.iter().filter(areas).map(|it| FIRST.start() + (it.index - FIRST.start()) % OBJECTS);
        let mut ranges: Vec<(u16, u16)> = Vec::new();
        let (mut open, mut all) = (false, true);
        for place in places.collect::<BTreeSet<_>>() {
            let shared = self.shared.contains_key(&place);
            match ranges.last_mut() {
                Some((_, last)) if shared && open => *last = place,
                _ if shared => ranges.push((place, place)),
                _ => {}
            }
            open = shared;
            all &= shared;
        }
        // One range for all is the area of the profile.
        if all && !ranges.is_empty() {
            return vec![(*FIRST.start(), *FIRST.end())];
        }
        ranges
    }

    /// Whether what has this index on the first axis has another on the others. It need not be in the dictionary: a PDO
    /// can map what is not.
    fn shifts(&self, index: u16) -> bool {
        self.ranges.iter().any(|(first, last)| (*first..=*last).contains(&index))
    }

    /// Whether an object is described with that of the first axis.
    pub(super) fn repeats(&self, index: u16) -> bool {
        let axis = index.checked_sub(*FIRST.start()).map_or(0, |it| it / OBJECTS);
        (1..self.count).contains(&axis) && self.shared.contains_key(&(index - axis * OBJECTS))
    }

    /// The indices that an object of the first axis has on all of them; its own if it is not one of these.
    pub(super) fn indices(&self, leading: u16) -> Vec<u16> {
        let axes = if self.shared.contains_key(&leading) { self.count } else { 1 };
        (0..axes).map(|axis| leading + axis * OBJECTS).collect()
    }

    /// Adds what differs on other axes to the table of an object.
    pub(super) fn complete(&self, index: u16, block: &mut Block) {
        if let Some(differing) = self.shared.get(&index).filter(|it| !it.is_empty()) {
            set(&mut block.keys, "per-axis", Toml::Table(differing.clone()));
        }
    }

    /// `[axes]`, with what each of them is.
    pub(super) fn block(
        &self,
        objects: &[Described],
        kind: Option<u16>,
        report: &mut Report,
    ) -> Option<Block> {
        let first = objects.iter().find(|it| it.index == 0x6040).filter(|_| self.count > 1)?;
        let notes = report.notes.len();
        if !self.are_named {
            let why = format!("there are {}, called by letters", self.count);
            report.guess(first.at, "the names of the axes", why);
        }
        let shifts = self.ranges.iter().map(|(first, last)| {
            let range = Toml::text(format!("0x{first:04X}..=0x{last:04X}"));
            Toml::Table(vec![("range".to_owned(), range), ("by".to_owned(), Toml::Hex(OBJECTS.into(), 3))])
        });
        let mut keys = vec![
            ("names".to_owned(), Toml::texts(&self.names)),
            ("shifts".to_owned(), Toml::List(shifts.collect())),
        ];
        let step = (self.pdo_step != PDOS).then(|| Toml::Hex(self.pdo_step.into(), 2));
        set_some(&mut keys, "pdo-shift", step);
        set_some(&mut keys, "add-info", kind.map(|kind| Toml::Integer(kind.into())));
        Some(Block { remarks: report.guessed_since(notes), ..Block::new("axes", None, keys) })
    }

    /// The PDOs of the first axis that all axes have, and those of the others that follow from them.
    pub(super) fn pdos(&self, pdos: &[&Pdo], report: &mut Report) -> (BTreeSet<u16>, BTreeSet<u16>) {
        let (mut leading, mut following) = (BTreeSet::new(), BTreeSet::new());
        if self.count < 2 {
            return (leading, following);
        }
        for (first, others) in self.leading(pdos, self.pdo_step) {
            leading.insert(first.index);
            for other in others {
                following.insert(other.index);
                if other.name != first.name {
                    let why = "it has that of the first axis";
                    report.lose(other.at, 1, "the name of a PDO of another axis", why);
                }
            }
        }
        (leading, following)
    }

    /// The PDOs that all axes have if theirs are so far apart, each with those of the other axes.
    fn leading<'p>(&self, pdos: &[&'p Pdo], step: u16) -> Vec<(&'p Pdo, Vec<&'p Pdo>)> {
        let by_index: BTreeMap<u16, &Pdo> = pdos.iter().map(|pdo| (pdo.index, *pdo)).collect();
        let mut following = BTreeSet::new();
        let mut found = Vec::new();
        for first in pdos {
            let other = |axis: u16| {
                let index = first.index.checked_add(axis.checked_mul(step)?)?;
                by_index.get(&index).copied().filter(|it| self.same(first, it, axis, step))
            };
            let others: Option<Vec<&Pdo>> = (1..self.count).map(other).collect();
            let Some(others) = others.filter(|_| !following.contains(&first.index)) else { continue };
            following.extend(others.iter().map(|it| it.index));
            found.push((*first, others));
        }
        found
    }

    fn same(&self, first: &Pdo, other: &Pdo, axis: u16, step: u16) -> bool {
        let shifted = |it: &PdoEntry| {
            let by = if self.shifts(it.index) { axis * OBJECTS } else { 0 };
            (it.index.wrapping_add(by), it.subindex, it.bits)
        };
        let excludes =
            |it: &Pdo, by: u16| it.excludes.iter().map(|it| it.0.wrapping_add(by)).collect::<BTreeSet<_>>();
        first.fixed == other.fixed
            && first.mandatory == other.mandatory
            && first.sm == other.sm
            && first.su == other.su
            && excludes(first, axis * step) == excludes(other, 0)
            && first
                .entries
                .iter()
                .map(shifted)
                .eq(other.entries.iter().map(|it| (it.index, it.subindex, it.bits)))
            && first.entries.iter().any(|it| self.shared.contains_key(&it.index))
    }
}

/// What people call axes of which nothing is known.
fn letter(axis: u16) -> String {
    u8::try_from(axis)
        .ok()
        .and_then(|axis| b'A'.checked_add(axis))
        .map(|letter| char::from(letter).to_string())
        .unwrap_or_default()
}

/// What an object has otherwise than that of the first axis; none if that cannot be said by single keys.
fn differing(first: &Described, other: &Described) -> Option<Keys> {
    let same_values = first.values.len() == other.values.len()
        && first
            .values
            .iter()
            .zip(&other.values)
            .all(|(one, other)| one.subindex == other.subindex && one.name == other.name);
    if first.kind != other.kind
        || !same_values && first.kind != Kind::Var
        || first.about != other.about
        || first.sdo_access != other.sdo_access
        || first.properties != other.properties
    {
        return None;
    }
    let mut keys = Keys::new();
    if let Some(name) = other.name.as_ref().filter(|name| Some(*name) != first.name.as_ref()) {
        set(&mut keys, "name", Toml::text(name));
    }
    if other.names != first.names {
        set(&mut keys, "names", other.names.clone()?);
    }
    if first.kind != Kind::Var {
        let same = first.category == other.category
            && first.values.iter().zip(&other.values).all(|(one, it)| one.keys == it.keys);
        return same.then_some(keys);
    }
    let (one, it) = (first.values.first()?, other.values.first()?);
    let has_all = one.keys.iter().all(|(name, _)| get(&it.keys, name).is_some());
    keys.extend(it.keys.iter().filter(|(name, value)| get(&one.keys, name) != Some(value)).cloned());
    has_all.then_some(keys)
}
