//! A thing that a tree describes.

use super::noun::noun;
use super::tree::{Tree, Trees};
use super::word::{Number, Phrase, number, numbers};
use crate::source::{Member, Node, Table, Value};

/// A table of a section: an object, a state, an error.
#[derive(Clone, Copy)]
pub(super) struct Entity<'t> {
    pub(super) tree: &'t Tree,
    pub(super) section: &'t str,
    pub(super) key: &'t str,
    pub(super) table: &'t Table,
}

impl<'t> Entity<'t> {
    /// All things of all trees.
    pub(super) fn everywhere(trees: &'t Trees) -> impl Iterator<Item = Self> {
        trees.trees.iter().flat_map(Self::all)
    }

    /// All things of a tree, in the order in which they stand there.
    pub(super) fn all(tree: &'t Tree) -> impl Iterator<Item = Self> {
        tree.root.members.iter().flat_map(move |section| {
            let members = section.node.table().map_or(&[][..], |table| &table.members);
            members.iter().filter_map(move |member| {
                let (section, key) = (&*section.key.name, &*member.key.name);
                Some(Self { tree, section, key, table: member.node.table()? })
            })
        })
    }

    /// A text that it has.
    pub(super) fn text(&self, key: &str) -> Option<&'t str> {
        text(self.table, key)
    }

    /// What it is called: its key, its id, its name.
    pub(super) fn names(&self) -> impl Iterator<Item = &'t str> + use<'t> {
        let key = Some(self.key).filter(|key| numbers(key).is_none());
        key.into_iter().chain(self.text("id")).chain(self.text("name"))
    }

    /// Its kind and key, as in `object 0x6064`.
    pub(super) fn title(&self) -> String {
        format!("{} {}", noun(self.section), self.key)
    }

    pub(super) fn is(&self, phrase: &Phrase) -> bool {
        self.names().any(|name| phrase.is(name))
    }

    /// Whether this number is its key or another code for it.
    pub(super) fn has(&self, number: i64) -> bool {
        let is = |node: &Node| matches!(node.value, Value::Integer(value) if value == i128::from(number));
        let aliases = match self.table.get("aliases").map(|member| &member.node.value) {
            Some(Value::Array(items)) => &items[..],
            _ => &[],
        };
        let code = self.table.get("code").map(|member| &member.node);
        numbers(self.key).is_some_and(|keys| keys.contains(&number)) || aliases.iter().chain(code).any(is)
    }

    /// Whether its key is written as this number is.
    pub(super) fn is_written_as(&self, number: Number) -> bool {
        let first = self.key.split("..=").next().unwrap_or(self.key);
        self::number(first).is_some_and(|key| key.is_hex == number.is_hex)
    }

    /// The entry of this subindex.
    pub(super) fn entry(&self, subindex: i64) -> Option<&'t Member> {
        let entries = self.table.get("entries")?.node.table()?;
        entries
            .members
            .iter()
            .find(|entry| numbers(&entry.key.name).is_some_and(|keys| keys.contains(&subindex)))
    }
}

/// A text in a table.
pub(super) fn text<'t>(table: &'t Table, key: &str) -> Option<&'t str> {
    match &table.get(key)?.node.value {
        Value::String(text) => Some(text),
        _ => None,
    }
}
