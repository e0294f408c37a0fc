//! What nobody writes on purpose: what a list names twice, and texts in which nothing is.

use std::collections::BTreeMap;

use crate::model::{Compare, Device, FieldPath, PathStep, Place, Section, Shape, Walker};
use crate::source::{Location, Origin};

/// A slip of the pen.
#[derive(Debug)]
pub(super) struct Slip {
    pub(super) place: Place,
    /// The key of the list or the text.
    pub(super) key: String,
    /// The item that the list has twice, for people; none for a text in which nothing is.
    pub(super) twice: Option<String>,
    /// Where it was written, the second time and the first time if twice.
    pub(super) at: [Location; 2],
}

/// What devc makes of other fields, and what is judged as a whole.
const BESIDE: &[&str] = &["startup", "repetitions", "assumptions"];

/// The slips in a device.
pub(super) fn of(device: &Device) -> Vec<Slip> {
    let mut walk = Walk { around: Vec::new(), found: Vec::new() };
    device.walk(&mut FieldPath::default(), &mut walk);
    walk.found
}

struct Walk {
    /// The parts around, each with the length of the path to it.
    around: Vec<(usize, Origin)>,
    found: Vec<Slip>,
}

impl Walk {
    fn find(&mut self, path: &FieldPath, twice: Option<String>, items: [Option<usize>; 2]) {
        let Some((depth, origin)) = self.around.last() else { return };
        if path.0.iter().any(|step| BESIDE.contains(&&**step)) {
            return;
        }
        let at = items.map(|item| origin.located(path.0.get(*depth..).unwrap_or_default(), item));
        self.found.extend(place(&path.0).map(|(place, key)| Slip { place, key, twice, at }));
    }
}

impl Walker for Walk {
    fn enter(&mut self, path: &FieldPath, origin: &Origin) {
        self.around.push((path.0.len(), origin.clone()));
    }

    fn leave(&mut self) {
        self.around.pop();
    }

    fn text(&mut self, path: &FieldPath, text: &str) {
        if text.trim().is_empty() {
            self.find(path, None, [None; 2]);
        }
    }

    fn list(&mut self, path: &FieldPath, items: &mut dyn Iterator<Item = String>) {
        let mut known = BTreeMap::new();
        for (place, item) in items.enumerate() {
            match known.get(&item).copied() {
                Some(first) => self.find(path, Some(item), [Some(place), Some(first)]),
                None => {
                    known.insert(item, place);
                }
            }
        }
    }
}

/// The place of a part of the model, and its key.
fn place(path: &[PathStep]) -> Option<(Place, String)> {
    let (field, rest) = path.split_first()?;
    let keys = |steps: &[PathStep]| steps.iter().map(|step| step.replace('_', "-")).collect::<Vec<_>>();
    let below = |place: Place, steps: &[PathStep]| keys(steps).into_iter().fold(place, Place::at);
    let key = keys(path).pop()?;
    let place = match (&**field, rest) {
        ("objects", [_, entries, address, rest @ ..]) if entries == "entries" => {
            below(Place::parse(address)?, rest)
        }
        ("objects" | "pdos", [index, rest @ ..]) => below(Place::parse(index)?, rest),
        ("arrangement", rest) => below(Section::Axes.into(), rest),
        (field, rest) => match (Section::of_field(field), rest) {
            (Some(section), [table, rest @ ..]) if section.shape() != Shape::Single => {
                below(Place::table(section, table), rest)
            }
            (Some(section), rest) => below(section.into(), rest),
            (None, _) => below(Section::Device.into(), path),
        },
    };
    Some((place, key))
}
