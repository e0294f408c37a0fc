//! What there is, a line each.

use super::entity::Entity;
use super::layout::{columns, paragraph};
use super::tree::Tree;

/// The columns of sections that have more to show than a name.
const COLUMNS: &[(&str, &[&str])] = &[
    ("objects", &["type", "access", "pdo", "name"]),
    ("words", &["about"]),
    ("states", &["name", "pattern"]),
    ("commands", &["name", "pattern"]),
    ("transitions", &["from", "to", "about"]),
    ("communication-transitions", &["from", "to", "about"]),
    ("modes", &["id", "name"]),
];

/// All that a tree has, by sections.
pub(super) fn of_tree(tree: &Tree) -> String {
    let about = format!("{}: {}", tree.name, tree.about);
    let mut parts: Vec<String> = about.split("\n\n").map(paragraph).collect();
    for section in &tree.root.members {
        let name = &*section.key.name;
        let entities: Vec<Entity<'_>> = Entity::all(tree).filter(|entity| entity.section == name).collect();
        if !entities.is_empty() {
            parts.push(lines(name, &entities));
        }
    }
    parts.push(paragraph(&format!("`devc explain {} <key or name>` tells more of one of them.", tree.name)));
    parts.join("\n\n")
}

/// The things of a section.
pub(super) fn of_section(entities: &[Entity<'_>]) -> String {
    let title = entities.first().map(|entity| format!("{} of {}", entity.section, entity.tree.name));
    lines(&title.unwrap_or_default(), entities)
}

fn lines(title: &str, entities: &[Entity<'_>]) -> String {
    let section = entities.first().map_or("", |entity| entity.section);
    let shown = COLUMNS.iter().find(|(key, _)| *key == section).map_or(&["name"][..], |(_, keys)| keys);
    let rows: Vec<Vec<String>> = entities.iter().map(|entity| row(*entity, shown)).collect();
    format!("{title}\n{}", columns(&rows).join("\n"))
}

fn row(entity: Entity<'_>, keys: &[&str]) -> Vec<String> {
    let cells = keys.iter().map(|key| match *key {
        "type" => data_type(entity),
        key => entity.text(key).unwrap_or_default().to_owned(),
    });
    std::iter::once(entity.key.to_owned()).chain(cells).collect()
}

/// The type of an object's values, and what holds them if there are several.
fn data_type(object: Entity<'_>) -> String {
    match (object.text("kind"), object.text("type")) {
        (Some(kind), Some(data_type)) => format!("{kind} of {data_type}"),
        (kind, data_type) => data_type.or(kind).unwrap_or_default().to_owned(),
    }
}
