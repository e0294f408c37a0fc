//! Objects, whose tables hold tables of their own and can differ from axis to axis.

use std::sync::Arc;

use super::decode::Reader;
use super::read::{Entity, Read, Sections};
use super::{RawEntries, RawEntry, RawFacts, RawObject, RawObjectHead};
use crate::model::Kind;
use crate::source::{Layer, Location, Member, Members, Node, Origin, Table, Value, keys};

/// The keys that an object's table can have for all of its entries.
pub(crate) const SHARED: &[&str] = &[
    "type",
    "access",
    "pdo",
    "safety",
    "category",
    "unit",
    "default",
    "min",
    "max",
    "values",
    "written",
    "backup",
    "setting",
    "effective",
    "stored",
    "functional",
    "trigger",
];

impl Read for RawObject {
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
            let table = on_axes(&table, axes, sections)?;
            Some((axes.key.name.to_string(), Self::read(Entity { section, key, header, table }, sections)?))
        });
        let per_axis = per_axis.collect();
        let origin = Origin::new(header, table);
        Some(Self { key: key.to_owned(), index, head, value, entries, shared, per_axis, source, origin })
    }
}

/// The object's table with what differs on some axes laid over.
fn on_axes(table: &Table, axes: &Member, sections: &mut Sections<'_>) -> Option<Arc<Table>> {
    let differing = sections.table(&axes.node)?;
    let mut shared = table.clone();
    shared.members.retain(|member| &*member.key.name != "per-axis");
    Some(Arc::new(differing.over(&shared)))
}

fn entries(member: &Member, object: &Table, sections: &mut Sections<'_>) -> Option<RawEntries> {
    let own = sections.table(&member.node)?;
    let Some(range) = keys::range::<u8>(&member.key.name) else {
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

/// The table of an entry with what the object's table says for all entries. What a description says there is more than
/// what a profile says of the entry.
fn with_shared(own: &Table, object: &Table) -> Table {
    let mut table = own.clone();
    for shared in object.members.iter().filter(|member| SHARED.contains(&&*member.key.name)) {
        match table.position(&shared.key.name).and_then(|place| table.members.get_mut(place)) {
            Some(own) if own.layer < shared.layer => {
                *own = Member { under: Some(Arc::new(own.node.clone())), ..shared.clone() };
            }
            Some(own) if own.under.is_none() && shared.layer < own.layer => {
                own.under = Some(Arc::new(shared.node.clone()))
            }
            Some(_) => {}
            None => table.members.push(shared.clone()),
        }
    }
    if let Some(assumed) = assumed(own, object) {
        table.members.retain(|member| member.key.name != assumed.key.name);
        table.members.push(assumed);
    }
    table
}

/// The reasons for what an entry says, and those of the object's table for what that says for all entries, and for its
/// entries; none if the object has no reasons, or the entry one for all of it.
fn assumed(own: &Table, object: &Table) -> Option<Member> {
    let reasons = object.get("assumed")?;
    let inherited = |key: &str| SHARED.contains(&key) && own.get(key).is_none();
    let mut all = match own.get("assumed").map(|own| &own.node.value) {
        None if !matches!(reasons.node.value, Value::Table(_)) => return Some(reasons.clone()),
        None => Table { at: reasons.node.at, members: Members::default() },
        Some(Value::Table(own)) => Table::clone(own),
        Some(_) => return None,
    };
    let shared: Members = match &reasons.node.value {
        Value::Table(keys) => keys.members.clone(),
        _ => {
            object.members.iter().map(|said| Member { node: reasons.node.clone(), ..said.clone() }).collect()
        }
    };
    let of_entries = shared.iter().find(|reason| &*reason.key.name == "entries").cloned();
    let of_entries = of_entries.into_iter().flat_map(|reason| {
        let said = own.members.iter().filter(|said| !matches!(&*said.key.name, "assumed" | "source"));
        said.map(move |said| Member { node: reason.node.clone(), ..said.clone() })
    });
    let shared = shared.iter().filter(|reason| inherited(&reason.key.name)).cloned().chain(of_entries);
    for reason in shared.filter(|reason| all.get(&reason.key.name).is_none()).collect::<Members>() {
        all.members.push(reason);
    }
    let node = Node { at: reasons.node.at, value: Value::Table(Arc::new(all)) };
    Some(Member { node, ..reasons.clone() })
}

/// The members of a table inside a table.
fn inner<'t>(table: &'t Table, name: &str) -> &'t [Member] {
    table.get(name).and_then(|member| member.node.table()).map_or(&[], |table| &table.members)
}
