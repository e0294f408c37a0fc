//! What entries of an object have that the source does not state as it stands here. What several of them have alike is
//! told once, at the object.

use super::doc::{Doc, departure};
use crate::model::{Device, Object, Provenance, assumption, facts};
use crate::raw::SHARED;
use crate::source::Value;

/// Those of all entries, each once.
pub(super) struct Departures(Vec<Departure>);

struct Departure {
    path: String,
    who: Provenance,
    /// The subindices of the entries that have it.
    subindices: Vec<u8>,
    /// Whether the object has it for all of its entries.
    is_of_object: bool,
}

impl Departures {
    pub(super) fn of(object: &Object) -> Self {
        let departs = |(_, who): &(String, Provenance)| {
            !matches!(who, Provenance::Stated | Provenance::Profile | Provenance::Derived)
        };
        let of_object: Vec<_> = facts(&object.origin).into_iter().filter(departs).collect();
        let of_whole = of_whole(object);
        let mut all: Vec<Departure> = Vec::new();
        for entry in &object.entries {
            for (path, who) in facts(&entry.origin).into_iter().filter(departs) {
                let subindex = entry.address.subindex;
                if let Some(known) = all.iter_mut().find(|known| known.path == path && known.who == who) {
                    known.subindices.push(subindex);
                    continue;
                }
                let key = path.split('.').next().unwrap_or_default();
                let is_said = || of_object.iter().any(|(other, by)| *other == path && *by == who);
                let is_of_object = SHARED.contains(&key) && is_said() || of_whole.as_ref() == Some(&who);
                all.push(Departure { path, who, subindices: vec![subindex], is_of_object });
            }
        }
        Self(all)
    }

    /// The documentation of the object, with what several of its entries have for themselves.
    pub(super) fn at_object(&self, doc: Doc, device: &Device) -> Doc {
        let shared = self.0.iter().filter(|known| known.is_shared() && !known.is_of_object);
        let sentences = together(shared).into_iter().filter_map(|(known, paths)| {
            let path = format!("{paths} of {}", spans(&known.subindices));
            departure(&path, &known.who, device)
        });
        doc.sentences(sentences)
    }

    /// The documentation of an entry, with what it alone has.
    pub(super) fn at_entry(&self, doc: Doc, subindex: u8, device: &Device) -> Doc {
        let own = self.0.iter().filter(|known| !known.is_shared() && known.subindices.contains(&subindex));
        let sentences = together(own).into_iter();
        doc.sentences(sentences.filter_map(|(known, paths)| departure(&paths, &known.who, device)))
    }
}

/// Those of the same entries for the same reason, with their keys.
fn together<'d>(all: impl Iterator<Item = &'d Departure>) -> Vec<(&'d Departure, String)> {
    let mut together: Vec<(&Departure, String)> = Vec::new();
    for one in all {
        let is_like = |other: &Departure| (&other.who, &other.subindices) == (&one.who, &one.subindices);
        match together.iter_mut().find(|(other, _)| is_like(other)) {
            Some((_, paths)) => *paths = format!("{paths}, {}", one.path),
            None => together.push((one, one.path.clone())),
        }
    }
    together
}

/// Why all of an object, or all of its entries, are assumed.
fn of_whole(object: &Object) -> Option<Provenance> {
    let reasons = object.origin.node("assumed")?;
    match (&reasons.value, assumption(&object.origin, "entries")) {
        (Value::String(reason), _) => Some(Provenance::Assumed(reason.to_string())),
        (_, of_entries) => of_entries.map(|reason| Provenance::Assumed(reason.to_owned())),
    }
}

impl Departure {
    /// Whether the object tells it.
    fn is_shared(&self) -> bool {
        self.is_of_object || self.subindices.len() > 1
    }
}

/// Numbers in order, in words: `1 to 4, 7`.
fn spans(numbers: &[u8]) -> String {
    let follow = |one: &u8, other: &u8| one.checked_add(1) == Some(*other);
    let spans = numbers.chunk_by(follow).filter_map(|span| match span {
        [] => None,
        [only] => Some(only.to_string()),
        [first, second] => Some(format!("{first}, {second}")),
        [first, .., last] => Some(format!("{first} to {last}")),
    });
    spans.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::spans;

    #[test]
    fn numbers_in_a_row_are_one_span() {
        assert_eq!(spans(&[1, 2, 3, 4, 7, 9, 10]), "1 to 4, 7, 9, 10");
    }
}
