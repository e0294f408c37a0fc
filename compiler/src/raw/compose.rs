//! One tree out of the description, its profiles, and what differs for a member of a family.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::source::{CanonicalKey, Member, Node, Table, Value, parts};

/// Lays each entity of `root` over the entity of the same key in `profile`.
///
/// What `root` does not mention stays out: a profile is a store of things to refer to, not a list of things
/// that a device has.
pub(crate) fn over_profile(root: &Table, profile: &Table) -> Table {
    let members = root
        .members
        .iter()
        .map(|section| match (section.node.table(), profile.get(&section.key.name)) {
            (Some(entities), Some(base)) => with(section, section_over(entities, base)),
            _ => section.clone(),
        })
        .collect();
    Table { at: root.at, members }
}

fn section_over(entities: &Table, base: &Member) -> Table {
    let known: BTreeMap<&CanonicalKey, &Node> = base
        .node
        .table()
        .map(|table| table.members.iter().map(|member| (&member.key.canonical, &member.node)).collect())
        .unwrap_or_default();
    let members = entities
        .members
        .iter()
        .map(|entity| {
            let lower = known.get(&entity.key.canonical).and_then(|node| node.table());
            match (entity.node.table(), lower) {
                (Some(upper), Some(lower)) => with(entity, upper.over(lower)),
                _ => entity.clone(),
            }
        })
        .collect();
    Table { at: entities.at, members }
}

/// Takes out what lists of paths name, and the key that holds them.
pub(super) fn strip(mut tree: Table, lists: &[Node], diagnostics: &mut Diagnostics) -> Table {
    for list in lists {
        let Value::Array(paths) = &list.value else {
            diagnostics.push(wrong_type(list, "an array of paths"));
            continue;
        };
        for path in paths.iter() {
            let Value::String(text) = &path.value else {
                diagnostics.push(wrong_type(path, "a path such as \"objects.0x6098\""));
                continue;
            };
            if !take_out(&mut tree, &parts(text).collect::<Vec<_>>()) {
                let message = format!("nothing stands at `{text}`");
                let label = "cannot be left out";
                diagnostics.push(Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, path.at, label));
            }
        }
    }
    tree.members.retain(|member| &*member.key.name != "without");
    tree
}

/// Takes out what stands at a path, and says whether there was anything.
fn take_out(table: &mut Table, path: &[&str]) -> bool {
    let Some((key, path)) = path.split_first() else { return false };
    let Some(place) = table.position(key) else { return false };
    if path.is_empty() {
        table.members.remove(place);
        forget(table, key);
        return true;
    }
    match table.members.get_mut(place).map(|member| &mut member.node.value) {
        Some(Value::Table(inner)) => take_out(Arc::make_mut(inner), path),
        _ => false,
    }
}

/// Takes the reason for a key out, when the key is taken out.
pub(super) fn forget(table: &mut Table, key: &str) {
    let reasons = table.position("assumed").and_then(|place| table.members.get_mut(place));
    if let Some(Value::Table(reasons)) = reasons.map(|assumed| &mut assumed.node.value)
        && let Some(place) = reasons.position(key)
    {
        Arc::make_mut(reasons).members.remove(place);
    }
}

fn with(member: &Member, table: Table) -> Member {
    let node = Node { at: member.node.at, value: Value::Table(Arc::new(table)) };
    Member { node, ..member.clone() }
}

/// That a value is of another type than its key needs.
pub(super) fn wrong_type(node: &Node, expected: &str) -> Diagnostic {
    let found = node.value.kind();
    let message = format!("expected {expected}, found {found}");
    Diagnostic::new(&faults::WRONG_TYPE, message, node.at, format!("this is {found}"))
}
