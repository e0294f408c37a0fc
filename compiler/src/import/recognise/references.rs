//! The words by which PDOs refer to entries.

use std::collections::BTreeMap;

use super::super::read::Object;
use super::super::toml::{Toml, get};
use super::axes::Axes;
use super::described::Described;
use super::profile::{Base, Known};
use crate::model::{DataType, Direction, Kind, ids};

/// What can be referred to, by index and subindex.
#[derive(Debug, Default)]
pub(super) struct References {
    targets: BTreeMap<(u16, u8), Target>,
    /// What can be mapped: to RxPDOs, and to TxPDOs.
    mappable: [bool; 2],
}

/// What a reference names.
#[derive(Debug)]
pub(super) struct Target {
    pub(super) text: String,
    /// The name that a mapped entry has if it is given none.
    pub(super) name: Option<String>,
    /// And in other languages.
    pub(super) names: Option<Toml>,
    pub(super) data_type: DataType,
    /// Whether it is described with that of the first axis, so that there is nothing of it to refer to.
    pub(super) is_repeated: bool,
}

impl References {
    /// An object is named by its id where no other has it, and none of those that are `made` of the PDOs; all else by index.
    pub(super) fn of(objects: &[Described], made: &[&Object], known: &Known, axes: &Axes) -> Self {
        let id = |object: &Described| {
            let base = known.object(object.index);
            base.and_then(Base::id).or_else(|| object.name.as_deref().map(ids::id))
        };
        let mut times: BTreeMap<String, usize> = BTreeMap::new();
        let of_made = made.iter().filter_map(|object| object.name.as_deref().map(ids::id));
        for id in objects.iter().filter_map(id).chain(of_made) {
            *times.entry(id).or_default() += 1;
        }
        let mut targets = BTreeMap::new();
        for object in objects {
            let is_repeated = axes.repeats(object.index);
            let is_own = |id: &String| times.get(id) == Some(&1) && is_word(id) && !is_repeated;
            let id = id(object).filter(is_own);
            let word = id.unwrap_or_else(|| format!("0x{:04X}", object.index));
            let base = known.object(object.index);
            for value in &object.values {
                let single = object.kind == Kind::Var;
                let text = if single { word.clone() } else { format!("{word}:{:X}", value.subindex) };
                let given = if single { &object.name } else { &value.name };
                let name = given.clone().or_else(|| base.filter(|_| single).and_then(Base::name));
                let names = if single { object.names.clone() } else { get(&value.keys, "names").cloned() };
                let target = Target { text, name, names, data_type: value.data_type, is_repeated };
                targets.insert((object.index, value.subindex), target);
            }
        }
        let goes = |way: &str| {
            let mut values = objects.iter().flat_map(|object| &object.values);
            values.any(|it| matches!(get(&it.keys, "pdo"), Some(Toml::Text(word)) if word.contains(way)))
        };
        Self { targets, mappable: ["rx", "tx"].map(goes) }
    }

    /// Whether anything in the dictionary can be mapped in a direction.
    pub(super) fn can_map(&self, direction: Direction) -> bool {
        let [rx, tx] = self.mappable;
        if direction == Direction::Rx { rx } else { tx }
    }

    pub(super) fn get(&self, index: u16, subindex: u8) -> Option<&Target> {
        self.targets.get(&(index, subindex))
    }
}

/// Whether an id cannot be taken for an index or a coordinate.
fn is_word(id: &str) -> bool {
    id != "unnamed" && id.len() > 2 && id.chars().next().is_some_and(|first| first.is_ascii_alphabetic())
}
