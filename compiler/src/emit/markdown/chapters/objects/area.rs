//! The areas of the dictionary: those that the description names, and those of the standard for the rest.

use std::collections::BTreeMap;

use crate::emit::markdown::context::Context;
use crate::model::{Area, Index, Object, Repeated, Source};

/// An area with what is in it.
pub(super) struct Contents<'a> {
    pub(super) first: u16,
    pub(super) name: &'a str,
    pub(super) about: Option<&'a str>,
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
        let (first, name, about) = area_of(named, object.index);
        match areas.iter_mut().find(|area| area.first == first && area.name == name) {
            Some(area) => area.objects.push(object),
            None => areas.push(Contents { first, name, about, objects: vec![object] }),
        }
    }
    areas
}

fn area_of(named: &[Area], index: Index) -> (u16, &str, Option<&str>) {
    let named = named.iter().find(|area| (area.first..=area.last).contains(&index));
    if let Some(area) = named {
        return (area.first.0, &area.name, area.about.as_deref());
    }
    let standard = STANDARD.iter().find(|(first, last, _)| (*first..=*last).contains(&index.0));
    standard.map_or((0, "Objects", None), |(first, _, name)| (*first, name, None))
}

/// Whether an object maps the PDO of an axis just as that of the first axis is mapped.
fn repeats_mapping(context: &Context<'_>, object: &Object) -> bool {
    context.device.pdo(object.index).is_some_and(|pdo| !pdo.is_leading())
}
