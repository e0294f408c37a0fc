//! The references of several members as one: what they share stands once, and what they do not names those
//! that have it.

use std::collections::BTreeSet;

use super::align::{Unit, align};
use super::names::Names;
use super::sections::{Led, Section, leads_up};
use super::{rows, sentences};
use crate::emit::markdown::holds::{Form, Holds};
use crate::emit::markdown::page::{Block, Page};

/// The references being brought together.
struct Merge<'n> {
    names: Names<'n>,
    page: Page,
}

/// Brings the references of members into one, where `names` are the words for them.
pub(super) fn merge(names: &[String], form: Form, pages: Vec<Page>) -> Page {
    let sections = pages.into_iter().map(Section::split).enumerate();
    let same = |one: &Section, other: &Section| one.heading == other.heading;
    let akin = |one: &Section, other: &Section| one.anchor().is_some() && one.anchor() == other.anchor();
    let mut merge = Merge { names: Names::new(names, form), page: Page::default() };
    let mut open: Vec<(usize, Vec<usize>)> = vec![(0, (0..names.len()).collect())];
    for unit in align(sections, same, akin) {
        let level = unit.items.first().map_or(0, |(_, section)| section.level());
        open.retain(|(outer, _)| *outer < level || *outer == 0);
        let around = open.last().map_or_else(Vec::new, |(_, members)| members.clone());
        open.push((level, unit.members()));
        merge.section(unit, &around);
    }
    with_first_anchors(merge.page)
}

impl Merge<'_> {
    fn section(&mut self, unit: Unit<Section>, around: &[usize]) {
        let members = unit.members();
        let mut heading = unit.items.first().and_then(|(_, section)| section.heading.clone());
        if let Some(heading) = heading.as_mut().filter(|_| members != around) {
            heading.holds = Holds::for_members(&members);
        }
        self.page.0.extend(heading.map(Block::Heading));
        if members != around {
            self.page.text(self.names.line("Only ", &members, "."));
        }
        let blocks = unit.items.into_iter().map(|(member, section)| (member, section.blocks));
        let mut told = members.clone();
        for unit in align(blocks, Led::is_version, |_, _| false) {
            // A caption has said already for whom the next block is.
            let last = self.page.0.iter().rfind(|block| block.is_read());
            let is_told = last.and_then(leads_up).is_some();
            let around = if is_told { &told } else { &members };
            if unit.members() == members {
                self.unit(&unit, around);
            } else {
                self.page.0.push(Block::Open(Holds::for_members(&unit.members())));
                self.unit(&unit, around);
                self.page.0.push(Block::Close);
            }
            told = unit.members();
        }
    }

    /// A block, or what members make of it; named are those that have it, unless all `around` do.
    fn unit(&mut self, unit: &Unit<Led>, around: &[usize]) {
        let members = unit.members();
        let Some(block) = self.versions(unit) else { return };
        let label = self.names.line("", &members, ":");
        match block {
            block if members == around => self.page.0.push(block),
            Block::Text(text) if is_running(&text) => self.page.text(format!("{label} {text}")),
            block => {
                self.page.text(label);
                self.page.0.push(block);
            }
        }
    }

    /// What becomes of the versions of a block.
    fn versions(&self, unit: &Unit<Led>) -> Option<Block> {
        let blocks = || unit.items.iter().map(|(member, led)| (*member, &led.block));
        let (_, first) = blocks().next()?;
        if blocks().all(|(_, block)| block == first) {
            return Some(first.clone());
        }
        Some(match first {
            Block::Table(_) => {
                let tables = blocks().filter_map(|(member, block)| match block {
                    Block::Table(table) => Some((member, table)),
                    _ => None,
                });
                Block::Table(rows::merge(&self.names, &tables.collect::<Vec<_>>()))
            }
            Block::List(_) => {
                let lists = blocks().filter_map(|(member, block)| match block {
                    Block::List(items) => Some((member, items.iter().collect())),
                    _ => None,
                });
                Block::List(sentences::list(&self.names, lists.collect()))
            }
            Block::Text(_) => {
                let texts = blocks().filter_map(|(member, block)| match block {
                    Block::Text(text) => Some((member, text.as_str())),
                    _ => None,
                });
                Block::Text(sentences::text(&self.names, &texts.collect::<Vec<_>>()))
            }
            Block::Heading(_) | Block::Lines(_) | Block::Machine(_) => first.clone(),
            Block::Picture(_) | Block::Open(_) | Block::Close => first.clone(),
        })
    }
}

/// Whether a paragraph can go on behind a label: it is no quotation, and begins with no code.
fn is_running(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || matches!(c, '*' | '[' | '<'))
}

/// The page with only the first of several anchors of the same name: versions of a thing stand together.
fn with_first_anchors(mut page: Page) -> Page {
    let mut seen = BTreeSet::new();
    for block in &mut page.0 {
        match block {
            Block::Heading(heading) => {
                heading.anchor = heading.anchor.take().filter(|anchor| seen.insert(anchor.clone()));
            }
            Block::List(items) => items.iter_mut().for_each(|item| first_anchors(&mut item.text, &mut seen)),
            Block::Table(table) => table.cells_mut().for_each(|cell| first_anchors(cell, &mut seen)),
            Block::Text(text) | Block::Lines(text) => first_anchors(text, &mut seen),
            Block::Machine(_) | Block::Picture(_) | Block::Open(_) | Block::Close => {}
        }
    }
    page
}

/// Takes out of a text the anchors that were seen before.
fn first_anchors(text: &mut String, seen: &mut BTreeSet<String>) {
    let mut parts = text.split("<a id=\"");
    let mut out = parts.next().unwrap_or("").to_owned();
    for part in parts {
        match part.split_once("\"></a>") {
            Some((id, rest)) if seen.insert(id.to_owned()) => {
                out.push_str(&format!("<a id=\"{id}\"></a>{rest}"))
            }
            Some((_, rest)) => out.push_str(rest),
            None => out.push_str(part),
        }
    }
    *text = out;
}
