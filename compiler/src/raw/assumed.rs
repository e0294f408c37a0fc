//! What tables say that no source states.

use std::sync::Arc;

use super::decode::keys;
use super::laid::{on_axes, with_shared};
use super::{RawEntry, RawFacts};
use crate::model::{Assumption, Place, Section};
use crate::source::keys::{number, range};
use crate::source::{Location, Member, Origin, Sources, Table, Value};

/// Looks for what is assumed in a table of a section.
pub(super) struct Assumed<'a> {
    /// The files in which it stands.
    pub(super) sources: &'a Sources,
    /// The key of the table, and what it is called: it can be assumed as well.
    pub(super) key: (&'a str, &'static str),
    /// The keys that such a table can have.
    pub(super) keys: &'a dyn Fn() -> Vec<&'static str>,
}

impl Assumed<'_> {
    /// The assumptions of a table and of all tables in it. What its facts are, be they said there or around it, is
    /// `whole`.
    pub(super) fn find(
        &self,
        place: &Place,
        header: Location,
        table: &Arc<Table>,
        whole: &Table,
    ) -> Vec<Assumption> {
        let mut found = self.own(place, header, table, whole);
        for (member, inner) in tables(table).filter(|(member, _)| &*member.key.name != "assumed") {
            let key = &*member.key.name;
            let place = place.clone().at(key);
            match key {
                "entries" | "per-axis" if place.section == Section::Objects => {
                    found.extend(self.of_object(&place, key, inner, whole));
                }
                _ => found.extend(self.find(&place, member.key.at, inner, inner)),
            }
        }
        found
    }

    /// Those of the entries of an object, or of what it is on axes.
    fn of_object(&self, place: &Place, key: &str, table: &Table, object: &Table) -> Vec<Assumption> {
        let found = tables(table).flat_map(|(member, inner)| {
            let whole = if key == "entries" { entry(member, object) } else { on_axes(inner, object) };
            let keys = if key == "entries" { &entry_keys } else { self.keys };
            Self { keys, ..*self }.find(&within(place, &member.key.name), member.key.at, inner, &whole)
        });
        found.collect()
    }

    fn own(&self, place: &Place, header: Location, table: &Arc<Table>, whole: &Table) -> Vec<Assumption> {
        let Some(assumed) = table.get("assumed") else { return Vec::new() };
        let one = |at: Place, key: Option<&str>, value: Option<String>, reason: &str| Assumption {
            at,
            key: key.map(str::to_owned),
            keys: Vec::new(),
            value,
            reason: reason.to_owned(),
            origin: Origin::new(header, table.clone()),
        };
        let keys = || (self.keys)().into_iter().map(str::to_owned).collect();
        match &assumed.node.value {
            Value::String(reason) => vec![one(place.clone(), None, None, reason)],
            Value::Table(reasons) => {
                let whole = Origin::new(header, whole.clone().into());
                let reasons = reasons.members.iter().filter_map(|member| match &member.node.value {
                    Value::String(reason) => Some((&*member.key.name, reason)),
                    _ => None,
                });
                let of_key = |(key, reason): (&str, &Arc<str>)| {
                    let value = whole.node(key).map(|node| text(self.sources, node.at));
                    let value = value.or_else(|| (self.key.1 == key).then(|| self.key.0.to_owned()));
                    let one = one(place.clone().at(key), Some(key), value, reason);
                    Assumption { keys: if one.value.is_none() { keys() } else { Vec::new() }, ..one }
                };
                reasons.map(of_key).collect()
            }
            _ => Vec::new(),
        }
    }
}

/// The tables in a table, with their keys.
fn tables(table: &Table) -> impl Iterator<Item = (&Member, &Arc<Table>)> {
    table.members.iter().filter_map(|member| Some((member, member.node.table()?)))
}

/// An entry with what its object says for all entries.
fn entry(member: &Member, object: &Table) -> Table {
    let own = object.get("entries").and_then(|entries| entries.node.table()?.get(&member.key.name));
    let own = own.and_then(|own| own.node.table()).or(member.node.table());
    let own =
        own.map_or_else(|| Table { at: object.at, members: Default::default() }, |own| Table::clone(own));
    if number(&member.key.name) == Some(0) { own } else { with_shared(&own, object) }
}

/// The keys that the table of an entry can have.
pub(crate) fn entry_keys() -> Vec<&'static str> {
    [keys::<RawEntry>(), keys::<RawFacts>()].concat()
}

/// The place of what stands under a key of the entries of an object, or of its axes. Entries have places of their own.
fn within(place: &Place, key: &str) -> Place {
    match (place.path.as_deref(), range::<u8>(key)) {
        (Some("entries"), Some(range)) => {
            Place { path: None, ..place.clone() }.entries((*range.start(), *range.end()))
        }
        _ => place.clone().at(key),
    }
}

/// The text that stands at a place, without the quotes.
fn text(sources: &Sources, at: Location) -> String {
    let text = sources
        .get(at.file)
        .and_then(|file| file.text.get(usize::try_from(at.start).ok()?..usize::try_from(at.end).ok()?));
    text.unwrap_or_default().trim_matches('"').to_owned()
}
