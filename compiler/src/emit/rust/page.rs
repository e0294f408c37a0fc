//! The dictionary by pages.

use std::collections::BTreeMap;

use super::stored::Home;
use crate::model::{Index, Object};

/// Objects whose indices share the high byte.
pub(super) struct Page<'a, 'h> {
    pub(super) high: u8,
    /// The objects, ascending by index, and where the values of each are if it has any that can change.
    pub(super) rows: Vec<(&'a Object, Option<&'h Home>)>,
}

impl<'a> Page<'a, '_> {
    /// The objects, ascending by index.
    pub(super) fn objects(&self) -> impl Iterator<Item = &'a Object> {
        self.rows.iter().map(|(object, _)| *object)
    }

    /// The axis from which the objects count theirs.
    pub(super) fn axis(&self) -> u8 {
        self.rows.iter().filter_map(|(_, home)| (*home)?.axis).min().unwrap_or(0)
    }
}

/// The pages of a dictionary, ascending by index.
pub(super) fn pages<'a, 'h>(objects: &'a [Object], homes: &'h BTreeMap<Index, Home>) -> Vec<Page<'a, 'h>> {
    let mut pages: Vec<Page<'a, 'h>> = Vec::new();
    for object in objects {
        let [high, _] = object.index.0.to_be_bytes();
        let row = (object, homes.get(&object.index));
        match pages.last_mut().filter(|page| page.high == high) {
            Some(page) => page.rows.push(row),
            None => pages.push(Page { high, rows: vec![row] }),
        }
    }
    pages
}
