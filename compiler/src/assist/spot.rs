//! What stands at a place of a text.

use std::ops::Range;

use crate::written::{Headed, Item, Key, Kind, Value, Written};

/// A key or a string.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Spot {
    /// The keys from the top of the file to it; for a key, itself included.
    pub(super) path: Vec<String>,
    /// Where it stands, a string with its quotes.
    pub(super) at: Range<usize>,
    /// What the string says; none for a key.
    pub(super) text: Option<String>,
}

impl Spot {
    /// The spot at a byte, or just before it.
    pub(super) fn at(text: &str, offset: usize) -> Option<Self> {
        let mut found = None;
        let written = Written::read(text);
        let table = written.tables.iter().rev().find(|table| table.header.start <= offset)?;
        tell_table(table, &mut |spot| {
            if (spot.at.start..=spot.at.end).contains(&offset) {
                found = Some(spot);
            }
        });
        found
    }

    /// The path within a device, without the member of a family in front.
    pub(super) fn plain(&self) -> Vec<&str> {
        plain(&self.path)
    }
}

/// A path within a device, without the member of a family in front.
pub(super) fn plain(path: &[String]) -> Vec<&str> {
    let rest = match path {
        [members, _, rest @ ..] if members == "members" => rest,
        all => all,
    };
    rest.iter().map(String::as_str).collect()
}

/// Tells each key and each string of a text, in order.
pub(super) fn all(text: &str, tell: &mut dyn FnMut(Spot)) {
    Written::read(text).tables.iter().for_each(|table| tell_table(table, tell));
}

fn tell_table(table: &Headed, tell: &mut dyn FnMut(Spot)) {
    let mut path = Vec::new();
    keys(&table.path, &mut path, tell);
    items(&table.items, &path, tell);
}

fn keys(keys: &[Key], path: &mut Vec<String>, tell: &mut dyn FnMut(Spot)) {
    for key in keys {
        path.push(key.name.clone());
        tell(Spot { path: path.clone(), at: key.at.clone(), text: None });
    }
}

fn items(items: &[Item], path: &[String], tell: &mut dyn FnMut(Spot)) {
    for item in items {
        let mut path = path.to_vec();
        keys(&item.path, &mut path, tell);
        if let Some(found) = &item.value {
            value(found, &path, tell);
        }
    }
}

fn value(found: &Value, path: &[String], tell: &mut dyn FnMut(Spot)) {
    match &found.kind {
        Kind::Text(text) => {
            tell(Spot { path: path.to_vec(), at: found.at.clone(), text: Some(text.clone()) });
        }
        Kind::Other => {}
        Kind::List(values) => values.iter().for_each(|inner| value(inner, path, tell)),
        Kind::Table(inner) => items(inner, path, tell),
    }
}
