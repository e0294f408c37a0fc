//! A file as it is written: its tables, keys and values with their places, however far its author has got.
//!
//! [`crate::source`] reads what a file means and stops at what is wrong. Who lays out a text or helps to write it needs
//! what stands where, comments and half a line included.

mod builder;
mod cursor;

use std::ops::Range;

pub(crate) use cursor::{Cursor, Slot, word};

use builder::Builder;

/// A file, from its first byte to its last.
#[derive(Debug, Default)]
pub(crate) struct Written {
    /// The tables under a header, in order; the first has none and holds what stands above all headers.
    pub(crate) tables: Vec<Headed>,
    /// Where comments stand, in order.
    pub(crate) comments: Vec<Range<usize>>,
}

/// A header with the lines below it.
#[derive(Debug, Default)]
pub(crate) struct Headed {
    /// The header with its brackets; empty for what stands above all headers.
    pub(crate) header: Range<usize>,
    /// The keys in the header.
    pub(crate) path: Vec<Key>,
    /// Whether it begins an element of a list, `[[remarks]]`.
    pub(crate) is_element: bool,
    /// The lines below it.
    pub(crate) items: Vec<Item>,
}

/// One part of a key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Key {
    /// What it says, without quotes.
    pub(crate) name: String,
    /// Where it stands, with its quotes.
    pub(crate) at: Range<usize>,
}

/// A key with what it is set to.
#[derive(Debug)]
pub(crate) struct Item {
    /// The key, of one part unless it has dots.
    pub(crate) path: Vec<Key>,
    /// None if nothing stands behind it yet.
    pub(crate) value: Option<Value>,
}

/// A value with its place.
#[derive(Debug)]
pub(crate) struct Value {
    /// Where it stands.
    pub(crate) at: Range<usize>,
    /// What it is.
    pub(crate) kind: Kind,
}

/// What a value is.
#[derive(Debug)]
pub(crate) enum Kind {
    /// A string, with what it says.
    Text(String),
    /// A number, `true`, a date, or what is not TOML.
    Other,
    /// A list.
    List(Vec<Value>),
    /// A table in braces.
    Table(Vec<Item>),
}

impl Written {
    /// Reads a text; what is not TOML in it is left out.
    pub(crate) fn read(text: &str) -> Self {
        Builder::read(text).finish()
    }
}

impl Item {
    /// Where it begins and ends.
    pub(crate) fn at(&self) -> Range<usize> {
        let (first, last) = (self.path.first(), self.path.last());
        let end = self.value.as_ref().map(|value| value.at.end).or(last.map(|key| key.at.end));
        first.map_or(0, |key| key.at.start)..end.unwrap_or_default()
    }
}

impl Headed {
    /// Where it begins and ends, without what stands above it.
    pub(crate) fn at(&self) -> Range<usize> {
        let end = self.items.last().map_or(self.header.end, |item| item.at().end);
        self.header.start..end.max(self.header.end)
    }
}

/// The names in a key.
pub(crate) fn names(path: &[Key]) -> impl Iterator<Item = &str> {
    path.iter().map(|key| key.name.as_str())
}
