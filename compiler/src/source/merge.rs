//! Several files of one description into one table.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{CanonicalKey, Key, Member, Node, Table, Value};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};

/// Adds the sections of a file to those of the files before it.
///
/// A section may be spread over files, an entity may not: only one file defines it.
pub(super) fn merge(base: &mut Table, part: Table, diagnostics: &mut Diagnostics) {
    for member in part.members {
        match base.members.iter_mut().find(|first| first.key.name == member.key.name) {
            Some(first) => join(first, member, diagnostics),
            None => base.members.push(member),
        }
    }
}

fn join(first: &mut Member, second: Member, diagnostics: &mut Diagnostics) {
    match (&mut first.node.value, second.node.value) {
        (Value::Table(first), Value::Table(second)) => {
            let first = Arc::make_mut(first);
            let keys = first.members.iter().map(|member| (member.key.canonical.clone(), member.key.clone()));
            let known: BTreeMap<CanonicalKey, Key> = keys.collect();
            for member in second.members.iter().cloned() {
                match known.get(&member.key.canonical) {
                    Some(other) => diagnostics.push(twice(other, &member.key)),
                    None => first.members.push(member),
                }
            }
        }
        (Value::Array(first), Value::Array(second)) if are_tables(first) && are_tables(&second) => {
            *first = first.iter().chain(second.iter()).cloned().collect();
        }
        _ => diagnostics.push(twice(&first.key, &second.key)),
    }
}

fn are_tables(items: &[Node]) -> bool {
    items.iter().all(|item| item.table().is_some())
}

fn twice(first: &Key, second: &Key) -> Diagnostic {
    let message = format!("`{}` is defined in two files", second.name);
    Diagnostic::new(&faults::DUPLICATE_DEFINITION, message, second.at, "defined again here")
        .label(first.at, "first defined here")
        .help("keep one of the two, with what both say")
}

/// The table with `source` in every entity that does not name its own.
///
/// Entities are the elements of lists of tables, and the members of sections that have only tables. One that is like
/// another has the source of that.
pub(super) fn with_default_source(mut table: Table, source: Option<&Member>) -> Table {
    let Some(source) = source else { return table };
    for member in &mut table.members {
        match &mut member.node.value {
            Value::Table(section) if section.members.iter().all(|entity| entity.node.table().is_some()) => {
                let section = Arc::make_mut(section);
                section.members.iter_mut().for_each(|entity| add_source(&mut entity.node, source));
            }
            Value::Array(items) if are_tables(items) => {
                let mut list = items.to_vec();
                list.iter_mut().for_each(|item| add_source(item, source));
                *items = list.into();
            }
            _ => {}
        }
    }
    table
}

fn add_source(entity: &mut Node, source: &Member) {
    if let Value::Table(table) = &mut entity.value
        && table.get(&source.key.name).is_none()
        && table.get("like").is_none()
    {
        Arc::make_mut(table).members.push(source.clone());
    }
}
