//! What a file has, as an outline.

use std::ops::Range;

use crate::written::{Headed, Item, Kind, Written, names};

/// A part of the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Symbol {
    /// Its keys.
    pub name: String,
    /// What it is called.
    pub detail: String,
    /// All of it, in bytes.
    pub at: Range<usize>,
    /// Its header or key.
    pub name_at: Range<usize>,
    /// What is in it.
    pub inside: Vec<Symbol>,
}

/// The outline of a text: each table, and in a section the things that have a line of their own.
pub fn symbols(text: &str) -> Vec<Symbol> {
    let written = Written::read(text);
    let headed = written.tables.iter().filter(|table| !table.path.is_empty());
    headed.map(of_table).collect()
}

fn of_table(table: &Headed) -> Symbol {
    let lines = table.items.iter().filter(|item| is_thing(item)).map(of_item);
    let name = names(&table.path).collect::<Vec<_>>().join(".");
    Symbol {
        name,
        detail: called(&table.items),
        at: table.at(),
        name_at: table.header.clone(),
        inside: lines.collect(),
    }
}

fn of_item(item: &Item) -> Symbol {
    let detail = match item.value.as_ref().map(|value| &value.kind) {
        Some(Kind::Table(items)) => called(items),
        _ => String::new(),
    };
    let (first, last) = (item.path.first(), item.path.last());
    let name_at = first.map_or(0, |key| key.at.start)..last.map_or(0, |key| key.at.end);
    Symbol {
        name: names(&item.path).collect::<Vec<_>>().join("."),
        detail,
        at: item.at(),
        name_at,
        inside: Vec::new(),
    }
}

fn is_thing(item: &Item) -> bool {
    matches!(item.value.as_ref().map(|value| &value.kind), Some(Kind::Table(_)))
}

/// What the lines of a thing say that it is called.
fn called(items: &[Item]) -> String {
    let text = |wanted: &str| {
        let item = items.iter().find(|item| names(&item.path).eq([wanted]))?;
        match &item.value.as_ref()?.kind {
            Kind::Text(text) => Some(text.clone()),
            _ => None,
        }
    };
    ["name", "title", "rule", "at"].into_iter().find_map(text).unwrap_or_default()
}
