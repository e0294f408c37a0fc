//! The references of several members as one: what they share stands once, and what they do not names those
//! that have it.

use std::collections::BTreeSet;

use super::align::{Unit, align};
use super::blocks::{Block, Section};
use super::names::Names;
use super::{rows, sentences};
use crate::emit::markdown::table::Table;

/// The references being brought together.
struct Merge<'n> {
    names: Names<'n>,
    text: String,
}

/// Brings the references of members into one, where `names` are the words for them.
pub(super) fn merge(names: &[String], texts: &[String]) -> String {
    let sections = texts.iter().map(|text| Section::split(text)).enumerate();
    let same = |one: &Section<'_>, other: &Section<'_>| one.heading == other.heading;
    let akin = |one: &Section<'_>, other: &Section<'_>| one.anchor.is_some() && one.anchor == other.anchor;
    let mut merge = Merge { names: Names(names), text: String::new() };
    let mut open: Vec<(usize, Vec<usize>)> = vec![(0, (0..names.len()).collect())];
    for unit in align(sections, same, akin) {
        let level = unit.items.first().map_or(0, |(_, section)| section.level());
        open.retain(|(outer, _)| *outer < level || *outer == 0);
        let around = open.last().map_or_else(Vec::new, |(_, members)| members.clone());
        open.push((level, unit.members()));
        merge.section(unit, &around);
    }
    first_anchors(&merge.text)
}

impl Merge<'_> {
    fn section(&mut self, unit: Unit<Section<'_>>, around: &[usize]) {
        let members = unit.members();
        if let Some((_, section)) = unit.items.first() {
            self.block(section.heading);
        }
        if members != around {
            self.block(&format!("*Only {}.*", self.names.running(&members)));
        }
        let blocks = unit.items.into_iter().map(|(member, section)| (member, section.blocks));
        let mut told = members.clone();
        for unit in align(blocks, Block::is_version, |_, _| false) {
            // A caption has said already for whom the next block is.
            let around = if self.text.ends_with(":\n\n") { &told } else { &members };
            self.unit(&unit, around);
            told = unit.members();
        }
    }

    /// A block, or what members make of it; named are those that have it, unless all `around` do.
    fn unit(&mut self, unit: &Unit<Block<'_>>, around: &[usize]) {
        let members = unit.members();
        let Some((_, first)) = unit.items.first() else { return };
        let text = self.versions(unit, first);
        let running = first.text.starts_with(|c: char| c.is_alphabetic() || matches!(c, '*' | '[' | '<'));
        let label = format!("*{}:*", self.names.running(&members));
        match members == around {
            true => self.block(&text),
            false if running => self.block(&format!("{label} {text}")),
            false => [label, text].iter().for_each(|block| self.block(block)),
        }
    }

    fn versions(&self, unit: &Unit<Block<'_>>, first: &Block<'_>) -> String {
        let texts = || unit.items.iter().map(|(member, block)| (*member, block.text));
        if texts().all(|(_, text)| text == first.text) {
            return first.text.to_owned();
        }
        let texts: Vec<(usize, &str)> = texts().collect();
        if first.is_table() {
            let tables: Vec<(usize, Table)> =
                texts.into_iter().map(|(member, text)| (member, Table::parse(text))).collect();
            return rows::merge(&self.names, &tables).to_string().trim_end().to_owned();
        }
        let merge = if first.is_list() { sentences::list } else { sentences::text };
        merge(&self.names, &texts)
    }

    fn block(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push_str("\n\n");
    }
}

/// The text with only the first of several anchors of the same name: versions of a thing stand together.
fn first_anchors(text: &str) -> String {
    let mut seen = BTreeSet::new();
    let mut parts = text.split("<a id=\"");
    let mut out = parts.next().unwrap_or("").to_owned();
    for part in parts {
        match part.split_once("\"></a>") {
            Some((id, rest)) if seen.insert(id) => out.push_str(&format!("<a id=\"{id}\"></a>{rest}")),
            Some((_, rest)) => out.push_str(rest),
            None => out.push_str(part),
        }
    }
    out
}
