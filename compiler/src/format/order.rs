//! What stands before what.

use crate::model::{Section, Shape as Kept};
use crate::reference::Shape;
use crate::written::{Headed, Key, names};

/// The keys that the format knows by name, in their order.
pub(super) fn keys(shape: Option<Shape>) -> Vec<&'static str> {
    shape.map(Shape::keys).unwrap_or_default().into_iter().map(|(key, _)| key).collect()
}

/// The place of a key among those of its table; where the format knows none by name, all stay as they are. What has
/// dots follows, as tables with a header of their own do.
pub(super) fn rank(known: &[&str], path: &[Key]) -> (bool, usize) {
    let place = path.first().and_then(|first| known.iter().position(|key| *key == first.name));
    (path.len() > 1 && !known.is_empty(), place.unwrap_or(known.len()))
}

/// The keys of a header up to those of the thing that it is about: `objects.0x6064` of `objects.0x6064.entries`.
pub(super) fn thing(table: &Headed) -> &[Key] {
    let length = match table.path.first().map(|key| key.name.as_str()) {
        Some("members") => 2 + table.path.get(2).map_or(0, |section| depth(&section.name)),
        Some(section) => depth(section),
        None => 0,
    };
    table.path.get(..length).unwrap_or(&table.path)
}

/// How many keys name a thing of a section, the section's own included.
fn depth(section: &str) -> usize {
    match Section::find(section).map(Section::shape) {
        Some(Kept::Words | Kept::Numbers | Kept::Indices) => 2,
        Some(Kept::Single | Kept::List) | None => 1,
    }
}

/// Whether the keys of the table at a path are indices.
pub(super) fn has_indices(path: &[&str]) -> bool {
    let section = match path {
        ["members", _, section] | [section] => section,
        _ => return false,
    };
    Section::find(section).is_some_and(|section| section.shape() == Kept::Indices)
}

/// The place of a table among those of a file: by its section, for a member of a family by the member first.
pub(super) fn place(table: &Headed, sections: &[&str], members: &[&str]) -> (usize, usize, usize) {
    let of = |name: &str| sections.iter().position(|section| *section == name).unwrap_or(sections.len());
    let mut path = names(&table.path);
    let first = path.next().map_or(0, |first| 1 + of(first));
    if table.path.first().is_none_or(|key| key.name != "members") {
        return (first, 0, 0);
    }
    let member = path.next().and_then(|name| members.iter().position(|member| *member == name));
    (first, member.unwrap_or_default(), path.next().map_or(0, |section| 1 + of(section)))
}
