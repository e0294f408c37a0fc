//! Sections with keys and values, as an EDS has them (CiA 306). Whatever nobody asked for is a loss.

use std::cell::Cell;
use std::collections::BTreeMap;

use super::element::{At, Unread};

/// A file.
#[derive(Debug, Default)]
pub(crate) struct Sheet<'t> {
    sections: Vec<Section<'t>>,
    /// The sections by their names in lower case; of two of one name the first.
    places: BTreeMap<String, usize>,
}

/// A section.
#[derive(Debug)]
pub(crate) struct Section<'t> {
    name: &'t str,
    at: At,
    keys: Vec<Key<'t>>,
    idle: Cell<bool>,
}

#[derive(Debug)]
struct Key<'t> {
    name: &'t str,
    value: &'t str,
    at: At,
    read: Cell<bool>,
}

impl<'t> Sheet<'t> {
    /// Reads a file, or says where and why it is none.
    pub(crate) fn parse(text: &'t str) -> Result<Self, (At, String)> {
        let mut sheet = Self::default();
        let mut start = 0;
        for line in text.split_inclusive('\n') {
            let at = At(start);
            start += line.len();
            // A semicolon begins a comment, where it is no part of a word before it.
            let line = line.split_once(" ;").map_or(line, |(line, _)| line).trim();
            if line.is_empty() || line.starts_with(';') {
                continue;
            }
            if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
                sheet.begin(name.trim(), at);
                continue;
            }
            let key = line.split_once('=').zip(sheet.sections.last_mut());
            let Some(((name, value), section)) = key else {
                return Err((at, "it is neither a section nor a key with a value".to_owned()));
            };
            let (name, value) = (name.trim(), value.trim());
            section.keys.push(Key { name, value, at, read: Cell::new(false) });
        }
        Ok(sheet)
    }

    fn begin(&mut self, name: &'t str, at: At) {
        self.places.entry(name.to_lowercase()).or_insert(self.sections.len());
        self.sections.push(Section { name, at, keys: Vec::new(), idle: Cell::new(false) });
    }

    /// The section of a name, in any case of letters.
    pub(crate) fn section(&self, name: &str) -> Option<&Section<'t>> {
        self.sections.get(*self.places.get(&name.to_lowercase())?)
    }

    /// All sections in order.
    pub(crate) fn sections(&self) -> &[Section<'t>] {
        &self.sections
    }

    /// How many facts it holds: keys with a value.
    pub(crate) fn facts(&self) -> usize {
        let told = self.sections.iter().filter(|section| !section.idle.get());
        told.flat_map(|section| &section.keys).filter(|key| !key.value.is_empty()).count()
    }

    /// What nobody read of it.
    pub(crate) fn unread(&self) -> Vec<Unread> {
        let told = self.sections.iter().filter(|section| !section.idle.get());
        let keys = told.flat_map(|section| section.keys.iter().map(move |key| (section, key)));
        let unread = keys.filter(|(_, key)| !key.read.get() && !key.value.is_empty());
        unread
            .map(|(section, key)| Unread {
                path: format!("[{}] {}", section.name, key.name),
                at: key.at,
                value: key.value.to_owned(),
                facts: 1,
            })
            .collect()
    }
}

impl<'t> Section<'t> {
    pub(crate) fn name(&self) -> &'t str {
        self.name
    }

    pub(crate) fn at(&self) -> At {
        self.at
    }

    /// The value of a key, in any case of letters, if it has one.
    pub(crate) fn text(&self, name: &str) -> Option<&'t str> {
        self.value_as(name, |value| Some(value).filter(|value| !value.is_empty()))
    }

    /// Where a key stands.
    pub(crate) fn place(&self, name: &str) -> At {
        let key = self.keys.iter().find(|key| key.name.eq_ignore_ascii_case(name));
        key.map_or(self.at, |key| key.at)
    }

    /// What the value of a key is read as; one that cannot be read so stays unread.
    pub(crate) fn value_as<T>(&self, name: &str, read: impl FnOnce(&'t str) -> Option<T>) -> Option<T> {
        let key = self.keys.iter().find(|key| key.name.eq_ignore_ascii_case(name))?;
        let value = read(key.value)?;
        key.read.set(true);
        Some(value)
    }

    /// Passes over each key whose name and value say nothing more.
    pub(crate) fn says_usual(&self, usual: impl Fn(&str, &str) -> bool) {
        self.keys.iter().filter(|key| usual(key.name, key.value)).for_each(|key| key.read.set(true));
    }

    /// Says that what is in it says nothing of the device: it counts neither as a fact nor as a loss.
    pub(crate) fn is_idle(&self) {
        self.idle.set(true);
    }
}
