//! Several files of one description into one table.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{CanonicalKey, Key, Member, Members, Node, Table, Value};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};

/// The sections of all files in one table, that of the first file.
///
/// A section may be spread over files, an entity may not: only one file defines it.
pub(super) fn merge(parts: impl IntoIterator<Item = Table>, diagnostics: &mut Diagnostics) -> Option<Table> {
    let mut parts = parts.into_iter().peekable();
    let at = parts.peek()?.at;
    let mut sections: Vec<Section> = Vec::new();
    let mut places: BTreeMap<Arc<str>, usize> = BTreeMap::new();
    for member in parts.flat_map(|part| part.members) {
        let place = *places.entry(member.key.name.clone()).or_insert(sections.len());
        match sections.get_mut(place) {
            Some(section) => section.join(member, diagnostics),
            None => sections.push(Section::new(member)),
        }
    }
    Some(Table { at, members: sections.into_iter().map(Section::whole).collect() })
}

/// A section while its parts come in.
struct Section {
    first: Member,
    content: Content,
}

enum Content {
    /// The entities, with the key of each by what it stands for once a second part asks.
    Entities(Vec<Member>, BTreeMap<CanonicalKey, Key>),
    Tables(Vec<Node>),
    /// What no second file can add to.
    Other,
}

impl Section {
    fn new(mut first: Member) -> Self {
        let content = match &mut first.node.value {
            Value::Table(table) => {
                let members = std::mem::take(&mut Arc::make_mut(table).members);
                Content::Entities(members.into_iter().collect(), BTreeMap::new())
            }
            Value::Array(items) if are_tables(items) => Content::Tables(items.to_vec()),
            _ => Content::Other,
        };
        Self { first, content }
    }

    fn join(&mut self, second: Member, diagnostics: &mut Diagnostics) {
        match (&mut self.content, second.node.value) {
            (Content::Entities(members, known), Value::Table(table)) => {
                if known.is_empty() {
                    known.extend(
                        members.iter().map(|member| (member.key.canonical.clone(), member.key.clone())),
                    );
                }
                for member in &table.members {
                    match known.get(&member.key.canonical) {
                        Some(other) => diagnostics.push(twice(other, &member.key)),
                        None => {
                            known.insert(member.key.canonical.clone(), member.key.clone());
                            members.push(member.clone());
                        }
                    }
                }
            }
            (Content::Tables(items), Value::Array(more)) if are_tables(&more) => {
                items.extend_from_slice(&more)
            }
            _ => diagnostics.push(twice(&self.first.key, &second.key)),
        }
    }

    fn whole(self) -> Member {
        let Self { mut first, content } = self;
        match (&mut first.node.value, content) {
            (Value::Table(table), Content::Entities(members, _)) => {
                Arc::make_mut(table).members = Members::from(members);
            }
            (Value::Array(items), Content::Tables(all)) => *items = all.into(),
            _ => {}
        }
        first
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
