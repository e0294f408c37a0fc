//! What is listed in the objects that devc makes, and in what form: names and kinds follow from what is mapped and assigned.

use super::super::read::{Object, PdoEntry, Shape};
use super::super::report::Report;
use super::derived::{ASSIGNMENTS, Basis, TYPES};
use super::references::References;
use super::words;
use crate::model::Entry;

/// Reports what an object has otherwise than devc makes it: names, which are counted once for each object, and whether it is
/// a record. Names that say no more than the subindex are none.
pub(super) fn told(object: &Object, basis: &Basis<'_>, references: &References, report: &mut Report) {
    let (list, kind) = match object.index {
        TYPES => ("0x1C00", Shape::Array),
        ASSIGNMENTS.. => ("an assignment object", Shape::Array),
        _ => ("a mapping object", Shape::Record),
    };
    let is_other = |subindex: u8, name: &str| match subindex {
        0 => name != Entry::COUNT,
        _ => made(object.index, subindex, basis, references).is_none_or(|made| made != name),
    };
    let named = object.values.iter().filter_map(|value| Some((value.subindex, value.name.as_deref()?)));
    let lost = named.filter(|(subindex, name)| !words::says_nothing(name) && is_other(*subindex, name));
    let lost = lost.count();
    if lost > 0 {
        let why = "they are those of what is listed, or numbers where that can change";
        report.lose(object.at, lost, format!("names in {list}"), why);
    }
    let lists = object.values.iter().any(|value| value.subindex > 0);
    if lists && object.shape != kind {
        let made = if kind == Shape::Array { "an array" } else { "a record" };
        report.lose(object.at, 0, format!("the kind of {list}"), format!("it is {made}"));
    }
}

/// The name of what is listed; none where it is a number.
fn made<'b>(index: u16, subindex: u8, basis: &Basis<'b>, references: &'b References) -> Option<String> {
    let place = usize::from(subindex.checked_sub(1)?);
    if index == TYPES {
        return basis.managers.get(place).map(|manager| format!("Sync manager {}", manager.number));
    }
    let pdo = basis.pdo(index).filter(|pdo| pdo.fixed)?;
    let entry: &PdoEntry = pdo.entries.get(place)?;
    let of_target = || references.get(entry.index, entry.subindex)?.name.clone();
    entry.name.clone().or_else(of_target)
}
