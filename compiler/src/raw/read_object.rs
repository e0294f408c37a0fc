//! Objects, whose tables hold tables of their own and can differ from axis to axis.

use std::sync::Arc;

use super::decode::{Reader, keys};
use super::laid::{on_axes, with_shared};
use super::read::{Entity, Read, Sections};
use super::{RawEntries, RawEntry, RawFacts, RawObject, RawObjectHead};
use crate::model::Kind;
use crate::source::keys::range;
use crate::source::{Layer, Location, Member, Members, Origin, Table};

impl Read for RawObject {
    const CALLED: &'static str = "index";

    fn keys() -> Vec<&'static str> {
        [keys::<RawObjectHead>(), keys::<RawEntry>(), keys::<RawFacts>()].concat()
    }

    fn read(entity: Entity<'_>, sections: &mut Sections<'_>) -> Option<Self> {
        let Entity { section, key, header, table } = entity;
        let Some(index) = sections.index(key) else {
            sections.no_index(key, header);
            return None;
        };
        let mut reader = Reader::new(&table, sections.diagnostics);
        let head = reader.part();
        let value = reader.part::<RawEntry>();
        let facts = reader.part::<RawFacts>();
        reader.finish();
        let (head, value, source): (RawObjectHead, _, _) = (head?, value?, sections.source(&facts?));
        // one value has no entries, whatever the profile's object has
        let is_own = |member: &&Member| head.kind != Some(Kind::Var) || member.layer != Layer::Profile;
        let own = inner(&table, "entries").iter().filter(is_own);
        let entries = own.filter_map(|member| entries(member, &table, sections));
        let entries = entries.collect();
        let shared = shared(&table, header, sections)?;
        let per_axis = inner(&table, "per-axis").iter().filter_map(|axes| {
            let differing = sections.table(&axes.node)?;
            let table = Arc::new(on_axes(&differing, &table));
            Some((axes.key.name.to_string(), Self::read(Entity { section, key, header, table }, sections)?))
        });
        let per_axis = per_axis.collect();
        let origin = Origin::new(header, table);
        Some(Self { key: key.to_owned(), index, head, value, entries, shared, per_axis, source, origin })
    }
}

fn entries(member: &Member, object: &Table, sections: &mut Sections<'_>) -> Option<RawEntries> {
    let own = sections.table(&member.node)?;
    let Some(range) = range::<u8>(&member.key.name) else {
        let expected = "a subindex from 0 to 255, or a range of them such as \"1..=16\"";
        sections.invalid(&member.key.name, expected, member.key.at);
        return None;
    };
    let range = (*range.start(), *range.end());
    let table = if range == (0, 0) { own } else { Arc::new(with_shared(&own, object)) };
    let mut reader = Reader::new(&table, sections.diagnostics);
    let value = reader.part();
    let facts = reader.part::<RawFacts>();
    reader.finish();
    let (value, source) = (value?, sections.source(&facts?));
    let many = member.key.name.contains("..=");
    Some(RawEntries { range, many, value, source, origin: Origin::new(member.key.at, table) })
}

/// What the object's table says for all entries, as an entry of which nothing else is said.
fn shared(object: &Table, header: Location, sections: &mut Sections<'_>) -> Option<RawEntries> {
    let table = Arc::new(with_shared(&Table { at: object.at, members: Members::default() }, object));
    let mut reader = Reader::new(&table, sections.diagnostics);
    let value = reader.part()?;
    Some(RawEntries {
        range: (1, u8::MAX),
        many: false,
        value,
        source: None,
        origin: Origin::new(header, table),
    })
}

/// The members of a table inside a table.
fn inner<'t>(table: &'t Table, name: &str) -> &'t [Member] {
    table.get(name).and_then(|member| member.node.table()).map_or(&[], |table| &table.members)
}
