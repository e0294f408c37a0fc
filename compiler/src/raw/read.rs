//! From the tree to structs, each table on its own.

use std::sync::Arc;

use serde::de::DeserializeOwned;

use super::assumed::Assumed;
use super::compose::wrong_type;
use super::decode::{Reader, keys, unknown_key};
use super::extent::judge_section;
use super::{RawFacts, RawSource};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::model::{Assumption, Index, Place, Section, Source, Table, Written};
use crate::source::keys::number;
use crate::source::{Location, Member, Members, Node, Origin, Sources, Value};

/// A table on its way to a struct.
pub(super) struct Entity<'t> {
    pub(super) section: Section,
    pub(super) key: &'t str,
    pub(super) header: Location,
    pub(super) table: Arc<crate::source::Table>,
}

/// What a table of a section is read into.
pub(super) trait Read: Sized {
    /// What the key of such a table is called; nothing if it says nothing of a device.
    const CALLED: &'static str = "";

    /// The keys that such a table can have.
    fn keys() -> Vec<&'static str>;

    /// Reads a table; none, and a report, if that cannot be done.
    fn read(entity: Entity<'_>, sections: &mut Sections<'_>) -> Option<Self>;
}

impl<T: Table + Default + DeserializeOwned> Read for T {
    const CALLED: &'static str = T::CALLED;

    fn keys() -> Vec<&'static str> {
        [keys::<T>(), keys::<RawFacts>()].concat()
    }

    fn read(entity: Entity<'_>, sections: &mut Sections<'_>) -> Option<Self> {
        let Entity { key, header, table, .. } = entity;
        // What a table under another key lacks is no help to who mistook the key.
        if !T::default().stand(key, None, Origin::default()) {
            sections.invalid(key, T::KEY, header);
            return None;
        }
        let mut reader = Reader::new(&table, sections.diagnostics);
        let value = reader.part::<T>();
        let facts = reader.part::<RawFacts>();
        reader.finish();
        let (mut value, source) = (value?, sections.source(&facts?));
        value.stand(key, source, Origin::new(header, table)).then_some(value)
    }
}

/// The top level of the tree while it is being read.
pub(super) struct Sections<'t> {
    tree: &'t crate::source::Table,
    sources: &'t Sources,
    pub(super) diagnostics: &'t mut Diagnostics,
    /// The ids of the documents.
    documents: Vec<String>,
    pub(super) coordinates: Option<super::RawCoordinates>,
    known: Vec<&'static str>,
    assumptions: Vec<Assumption>,
    written: Vec<Written>,
}

impl<'t> Sections<'t> {
    pub(super) fn new(
        tree: &'t crate::source::Table,
        sources: &'t Sources,
        diagnostics: &'t mut Diagnostics,
    ) -> Self {
        let documents = tree.get("documents").and_then(|section| section.node.table());
        let documents = documents.iter().flat_map(|section| &section.members);
        let documents = documents.map(|document| document.key.name.to_string()).collect();
        // Objects can stand under coordinates, so that these are read first; what is wrong with them is said later.
        let coordinates = tree.get("coordinates").and_then(|section| section.node.table());
        let coordinates =
            coordinates.and_then(|table| Reader::new(table, &mut Diagnostics::default()).part());
        let (known, assumptions, written) = (Vec::new(), Vec::new(), Vec::new());
        Self { tree, sources, diagnostics, documents, coordinates, known, assumptions, written }
    }

    /// The one table of a section.
    pub(super) fn single<T: Read>(&mut self, section: Section) -> Option<T> {
        let Some(member) = self.take(section.name()) else {
            if matches!(section, Section::Device | Section::Identity) {
                let message = format!("the description has no `[{}]`", section.name());
                let missing =
                    Diagnostic::new(&faults::MISSING_KEY, message, self.tree.at, "in this description");
                self.diagnostics.push(missing);
            }
            return None;
        };
        self.entity(section, "", member.key.at, &member.node)
    }

    /// The tables of a section by their keys.
    pub(super) fn map<T: Read>(&mut self, section: Section) -> Vec<T> {
        let members = self.members(section.name());
        members.iter().filter_map(|m| self.entity(section, &m.key.name, m.key.at, &m.node)).collect()
    }

    /// The tables of a list.
    pub(super) fn list<T: Read>(&mut self, section: Section) -> Vec<T> {
        let Some(member) = self.take(section.name()) else { return Vec::new() };
        let Value::Array(items) = &member.node.value else {
            self.diagnostics.push(wrong_type(&member.node, "an array of tables"));
            return Vec::new();
        };
        let items = items.iter().enumerate();
        items.filter_map(|(i, node)| self.entity(section, &i.to_string(), node.at, node)).collect()
    }

    fn entity<T: Read>(&mut self, section: Section, key: &str, header: Location, node: &Node) -> Option<T> {
        let table = self.table(node)?;
        let place = self.place(section, key);
        self.written.push(Written {
            sourced: table.get("source").is_some_and(|source| source.node.value != Value::Boolean(false)),
            assumed: table
                .get("assumed")
                .is_some_and(|assumed| matches!(assumed.node.value, Value::String(_))),
            place: place.clone(),
            origin: Origin::new(header, table.clone()),
        });
        let assumed = Assumed { sources: self.sources, key: (key, T::CALLED), keys: &T::keys };
        self.assumptions.extend(assumed.find(&place, header, &table, &table));
        T::read(Entity { section, key, header, table }, self)
    }

    /// The place of a table; that of an object is its index, under whatever coordinate it stands.
    fn place(&self, section: Section, key: &str) -> Place {
        match self.index(key).filter(|_| section == Section::Objects) {
            Some(index) => Place { section, ..index.into() },
            None => Place::table(section, key),
        }
    }

    /// The index that the key of an object stands for: hexadecimal, or a coordinate of the vendor.
    pub(super) fn index(&self, key: &str) -> Option<Index> {
        let index = key.strip_prefix("0x").and_then(|_| number(key)).and_then(|n| u16::try_from(n).ok());
        let coordinate = || self.coordinates.as_ref()?.address(key).map(|address| address.index);
        index.map(Index).or_else(coordinate)
    }

    /// The place that a `source` names: in the document before the colon, or in the main one.
    pub(super) fn source(&self, facts: &RawFacts) -> Option<Source> {
        let Some(RawSource::Place(text)) = &facts.source else { return None };
        let known = |id: &str| self.documents.iter().any(|document| document == id);
        Some(match text.split_once(": ") {
            Some((document, place)) if known(document) => {
                Source { document: Some(document.to_owned()), place: place.to_owned() }
            }
            _ => Source { document: self.documents.first().cloned(), place: text.clone() },
        })
    }

    /// Reports a key that cannot be read, and says what could.
    pub(super) fn invalid(&mut self, key: &str, expected: &str, at: Location) {
        self.diagnostics.push(meaningless(key, expected, at));
    }

    /// Reports a key that is no index, with the one that is meant by a number without `0x`.
    pub(super) fn no_index(&mut self, key: &str, at: Location) {
        let fault = meaningless(key, "an index such as 0x6040", at);
        self.diagnostics.push(match Index::meant(key) {
            Some(index) => fault.suggest(format!("is {index} meant?"), at, index.to_string()),
            None => fault,
        });
    }

    pub(super) fn table(&mut self, node: &Node) -> Option<Arc<crate::source::Table>> {
        let table = node.table().cloned();
        if table.is_none() {
            self.diagnostics.push(wrong_type(node, "a table"));
        }
        table
    }

    /// The members of a section that is a table.
    pub(super) fn members(&mut self, name: &'static str) -> Members {
        let table = self.take(name).and_then(|section| self.table(&section.node));
        table.map_or_else(Members::default, |table| {
            judge_section(name, &table, self.diagnostics);
            table.members.clone()
        })
    }

    fn take(&mut self, name: &'static str) -> Option<Member> {
        self.known.push(name);
        self.tree.get(name).cloned()
    }

    /// Reports sections that the format does not know, and gives what was gathered on the way.
    pub(super) fn finish(mut self) -> (Vec<Assumption>, Vec<Written>) {
        self.known.extend(["include", "profiles", "source", "without", "members"]);
        for member in &self.tree.members {
            if !self.known.contains(&&*member.key.name) {
                self.diagnostics.push(unknown_key(&member.key, &self.known));
            }
        }
        (self.assumptions, self.written)
    }
}

fn meaningless(key: &str, expected: &str, at: Location) -> Diagnostic {
    let message = format!("`{key}` means nothing here");
    Diagnostic::new(&faults::INVALID_VALUE, message, at, format!("expected {expected}"))
}
