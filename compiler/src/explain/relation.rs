//! Who refers to whom.

use super::entity::{Entity, text};
use super::tree::Tree;
use crate::source::{Node, Value};

/// A key whose values name things of another section.
struct Relation {
    section: &'static str,
    key: &'static str,
    target: &'static str,
    /// What the one that is named says of those that name it.
    says: &'static str,
}

const RELATIONS: &[Relation] = &[
    relation("modes", "objects", "objects", "used by"),
    relation("transitions", "from", "states", "left by"),
    relation("transitions", "to", "states", "entered by"),
    relation("commands", "transitions", "transitions", "set off by"),
    relation("communication-transitions", "from", "communication-states", "left by"),
    relation("communication-transitions", "to", "communication-states", "entered by"),
];

const fn relation(
    section: &'static str,
    key: &'static str,
    target: &'static str,
    says: &'static str,
) -> Relation {
    Relation { section, key, target, says }
}

/// Those that refer to a thing, by what they do with it.
pub(super) fn referring<'t>(entity: Entity<'t>) -> Vec<(&'static str, Vec<Entity<'t>>)> {
    let own = RELATIONS.iter().filter(|relation| relation.target == entity.section);
    let referring = own.map(|relation| {
        let others = Entity::all(entity.tree).filter(|other| other.section == relation.section);
        let others = others
            .filter(|other| other.table.get(relation.key).is_some_and(|member| names(&member.node, entity)));
        (relation.says, others.collect::<Vec<_>>())
    });
    referring.filter(|(_, others)| !others.is_empty()).collect()
}

/// The word whose bits the values of an object, or of an entry of it, are.
pub(super) fn word<'t>(object: Entity<'t>, entry: Option<&str>) -> Option<Entity<'t>> {
    let id = object.text("id").filter(|_| object.section == "objects")?;
    let of_entry = entry.map(|entry| format!("{id}:{entry}"));
    of(object.tree, "words").find(|word| match &of_entry {
        Some(entry) => word.text("object") == Some(entry),
        None => word.key == id,
    })
}

/// What modes make of a bit that a word leaves to them, by the name of each.
pub(super) fn in_modes(word: Entity<'_>, bit: &str) -> Vec<String> {
    let Some((_, key)) = LEFT_TO_MODES.iter().find(|(id, _)| *id == word.key) else { return Vec::new() };
    let names = of(word.tree, "modes").filter_map(|mode| {
        let bit = &mode.table.get(key)?.node.table()?.get(bit)?.node;
        let name = match &bit.value {
            Value::String(name) => name,
            _ => text(bit.table()?, "name")?,
        };
        Some(format!("{}: {name}", mode.title()))
    });
    names.collect()
}

/// The words that leave bits to modes, with the key that has them in a mode.
const LEFT_TO_MODES: &[(&str, &str)] = &[("controlword", "control-bits"), ("statusword", "status-bits")];

fn of<'t>(tree: &'t Tree, section: &str) -> impl Iterator<Item = Entity<'t>> {
    Entity::all(tree).filter(move |entity| entity.section == section)
}

/// Whether a value, or one of a list, is the key or the id of a thing.
fn names(node: &Node, entity: Entity<'_>) -> bool {
    match &node.value {
        Value::Array(items) => items.iter().any(|item| names(item, entity)),
        Value::String(text) => **text == *entity.key || entity.text("id") == Some(text),
        Value::Integer(number) => number.to_string() == entity.key,
        _ => false,
    }
}
