//! The areas of the dictionary: those that the description names, and those of the standard for the rest.

use std::collections::BTreeMap;

use crate::emit::markdown::context::Context;
use crate::model::{Area, Index, Object, Repeated, Source};

/// An area with what is in it.
pub(super) struct Contents<'a> {
    pub(super) first: u16,
    pub(super) name: &'a str,
    /// What names it; none if the standard does.
    pub(super) described: Option<&'a Area>,
    pub(super) objects: Vec<&'a Object>,
}

impl<'a> Contents<'a> {
    /// Where most of its objects are from, if it is more than one.
    pub(super) fn common_source(&self) -> Option<&'a Source> {
        let mut counts: BTreeMap<(Option<&str>, &str), (usize, &'a Source)> = BTreeMap::new();
        for source in self.objects.iter().filter_map(|object| object.source.as_ref()) {
            counts.entry((source.document.as_deref(), &source.place)).or_insert((0, source)).0 += 1;
        }
        let (count, source) = counts.into_values().max_by_key(|(count, _)| *count)?;
        (count > 1).then_some(source)
    }
}

/// The parts of the dictionary by CiA 301 and ETG.1000.6.
const STANDARD: [(u16, u16, &str); 4] = [
    (0x0000, 0x0FFF, "Data types"),
    (0x1000, 0x1FFF, "Communication"),
    (0x2000, 0x5FFF, "Manufacturer"),
    (0x6000, 0xFFFF, "Profile"),
];

/// The areas that are not empty, by index.
pub(super) fn areas<'a>(context: &Context<'a>, named: &'a [Area]) -> Vec<Contents<'a>> {
    let mut areas: Vec<Contents<'a>> = Vec::new();
    for object in context.leading_objects().filter(|object| !repeats_mapping(context, object)) {
        let described = named.iter().find(|area| (area.first..=area.last).contains(&object.index));
        let own = described.map(|area| (area.first.0, area.name.as_str()));
        let (first, name) = own.unwrap_or_else(|| standard(object.index));
        match areas.iter_mut().find(|area| area.first == first && area.name == name) {
            Some(area) => area.objects.push(object),
            None => areas.push(Contents { first, name, described, objects: vec![object] }),
        }
    }
    areas
}

/// The first index and the name of an area that the description does not name.
fn standard(index: Index) -> (u16, &'static str) {
    let standard = STANDARD.iter().find(|(first, last, _)| (*first..=*last).contains(&index.0));
    standard.map_or((0, "Objects"), |(first, _, name)| (*first, name))
}

/// Whether an object maps the PDO of an axis just as that of the first axis is mapped.
fn repeats_mapping(context: &Context<'_>, object: &Object) -> bool {
    context.device.pdo(object.index).is_some_and(|pdo| !pdo.is_leading())
}
