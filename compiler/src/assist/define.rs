//! Where something is defined.

use super::Knowledge;
use super::spot::Spot;
use super::thing::of;
use crate::model::Section;
use crate::reference::relation::{Names, names};
use crate::source::Location;

/// Where to go.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Definition {
    /// A file, relative to the one that names it.
    File(String),
    /// A profile as a whole.
    Profile(String),
    /// A place in a text of [`Knowledge::sources`].
    At(Location),
}

/// Where what stands at a byte of a text is defined: what a value names; of a key, what a profile says of it.
pub fn define(text: &str, offset: usize, knowledge: Option<&Knowledge>) -> Option<Definition> {
    let spot = Spot::at(text, offset)?;
    let path = spot.plain();
    let Some(word) = &spot.text else { return of_key(&path, knowledge?) };
    match names(&path) {
        Some(Names::Files) => Some(Definition::File(word.clone())),
        Some(Names::Profiles) => Some(Definition::Profile(word.clone())),
        Some(names) => {
            let knowledge = knowledge?;
            let thing = knowledge.named(names, path.first()?, word)?;
            let subindex =
                word.split_once(':').and_then(|(_, entry)| i64::from_str_radix(entry.trim(), 16).ok());
            let entry = subindex.and_then(|subindex| {
                let mut entries = thing.entries().iter();
                entries.find(|entry| crate::source::keys::number(&entry.key.name) == Some(subindex))
            });
            Some(Definition::At(entry.map_or(thing.member.key.at, |entry| entry.key.at)))
        }
        None => of_key(&path, knowledge?),
    }
}

/// What lies under a key in a profile; an error or a word of an object is defined by the object.
fn of_key(path: &[&str], knowledge: &Knowledge) -> Option<Definition> {
    if let Some(member) = knowledge.in_profile(path) {
        return Some(Definition::At(member.key.at));
    }
    match path {
        ["words", id] => {
            let mut objects = of(&knowledge.root, Section::Objects);
            objects.find(|object| object.is(id)).map(|object| Definition::At(object.member.key.at))
        }
        _ => None,
    }
}
