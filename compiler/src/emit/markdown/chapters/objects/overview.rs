//! The table of an area: a line for each value.

use std::collections::BTreeSet;

use super::is_mapping;
use super::kinds;
use super::marks::{Marks, demanded};
use crate::emit::markdown::context::{Context, is_single};
use crate::emit::markdown::holds::Holds;
use crate::emit::markdown::inline::{anchor, code, link, text};
use crate::emit::markdown::table::Table;
use crate::model::{
    Access, Category, DataType, Entry, Kind, Mappable, Object, Provenance, Value, facts, provenance,
};
use crate::source::Origin;

/// The table as it grows. Subindex 0 of a record has a line only if it is not simply the highest subindex,
/// and a mapping object has no lines for its entries.
pub(super) struct Lines<'c, 'a> {
    context: &'c Context<'a>,
    marks: Marks,
    pub(super) table: Table,
}

impl<'c, 'a> Lines<'c, 'a> {
    /// No lines yet of these objects.
    pub(super) fn new(context: &'c Context<'a>, objects: &[&Object]) -> Self {
        let titles = [
            "Index",
            "Name",
            "Type",
            "Access",
            "PDO",
            "Default",
            "Unit",
            "Range",
            "Need",
            "Written in",
            "Parameter",
        ];
        Self { context, marks: Marks::new(context, objects), table: Table::new(titles) }
    }

    /// Adds the lines of an object, linked to what else there is to say of it if it is `described`.
    pub(super) fn object(&mut self, object: &Object, described: bool) {
        let index = self.index(object, described);
        let context = self.context;
        let name = format!("**{}**{}", text(&object.name), self.marks.object(context, object));
        match object.entries.as_slice() {
            [only] if is_single(object) => {
                let need = demanded(object, only);
                let mut facts = self.facts(only, need);
                if let Some(parameter) = &object.parameter {
                    facts[8] = text(parameter) + &self.marks.own(context, &object.origin, "parameter");
                }
                facts[0] += &self.marks.own(context, &object.origin, "kind");
                self.line(kinds::single(object, only), [index, name], facts);
            }
            entries => {
                let mut head: [String; 9] = Default::default();
                head[0] = kind(object.kind).to_owned() + &self.marks.own(context, &object.origin, "kind");
                head[6] = self.marks.category(object.category);
                if let Some(parameter) = &object.parameter {
                    head[8] = text(parameter) + &self.marks.own(context, &object.origin, "parameter");
                }
                self.line(kinds::compound(object), [index, name], head);
                let shown =
                    |entry: &&Entry| !is_mapping(context, object) && !is_count(context, object, entry);
                for entry in entries.iter().filter(shown).collect::<Vec<_>>() {
                    let subindex = format!("&emsp;{}", code(format!(":{:02X}", entry.address.subindex)));
                    let facts = self.facts(entry, said_need(entry));
                    let name = text(&entry.name) + &self.marks.own(context, &entry.origin, "name");
                    self.line(kinds::entry(entry), [subindex, name], facts);
                }
            }
        }
    }

    /// What the marks in the table mean.
    pub(super) fn legend(&self) -> String {
        self.marks.legend()
    }

    fn line(&mut self, kinds: BTreeSet<&'static str>, name: [String; 2], facts: [String; 9]) {
        let holds = Holds { kinds, ..Holds::default() };
        self.table.row_for(holds, name.into_iter().chain(facts));
    }

    fn index(&self, object: &Object, described: bool) -> String {
        let (context, label) = (self.context, code(object.index));
        match described {
            _ if is_mapping(context, object) => context.index(object.index),
            true => link(label, context.object_id(object)),
            false => format!("{}{label}", anchor(context.object_id(object))),
        }
    }

    fn facts(&mut self, entry: &Entry, need: Category) -> [String; 9] {
        let context = self.context;
        let window = entry.written.map_or(String::new(), |window| code(window.name()));
        [
            format!("{}{}", entry.data_type, self.marks.data_type(context, entry)),
            self.marks.fact(context, entry, &["access"], access(entry.access).into()),
            self.marks.fact(context, entry, &["pdo"], mappable(entry.pdo).into()),
            self.marks.fact(context, entry, &["default"], context.default(entry)),
            self.marks.fact(context, entry, &["unit"], context.unit(entry)),
            self.marks.fact(context, entry, &["min", "max"], context.range(entry)),
            self.marks.category(need),
            self.marks.fact(context, entry, &["written"], window),
            self.marks.fact(
                context,
                entry,
                &["parameter"],
                entry.parameter.as_deref().map_or(String::new(), text),
            ),
        ]
    }
}

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Var => "",
        Kind::Array => "*array*",
        Kind::Record => "*record*",
    }
}

/// Whether an entry is subindex 0 as it is in every record: the highest subindex, for reading, of which nothing else is to
/// be said.
pub(super) fn is_count(context: &Context<'_>, object: &Object, entry: &Entry) -> bool {
    let plain = entry.data_type == DataType::Uint(8) && !entry.access.writable();
    let highest = entry.default == Some(Value::Integer(object.highest_subindex().into()));
    let silent = entry.values.is_empty()
        && entry.parameter.is_none()
        && !(context.editorial && departs(&entry.origin));
    !is_single(object) && entry.address.subindex == 0 && plain && highest && silent
}

/// Whether a profile demands an entry. That there is subindex 0 follows from there being others.
fn said_need(entry: &Entry) -> Category {
    match provenance(&entry.origin, "category") {
        Provenance::Derived if entry.address.subindex == 0 => Category::Optional,
        _ => entry.category,
    }
}

/// Whether a table has something that its source does not state as it stands here.
fn departs(origin: &Origin) -> bool {
    facts(origin)
        .iter()
        .any(|(_, who)| !matches!(who, Provenance::Stated | Provenance::Profile | Provenance::Derived))
}

/// The access as people abbreviate it.
pub(super) fn access(access: Access) -> &'static str {
    match access {
        Access::Ro => "ro",
        Access::Wo => "wo",
        Access::Rw => "rw",
        Access::Const => "const",
    }
}

/// The kinds of PDO as people abbreviate them.
pub(super) fn mappable(pdo: Mappable) -> &'static str {
    match pdo {
        Mappable::None => "",
        Mappable::Rx => "Rx",
        Mappable::Tx => "Tx",
        Mappable::RxTx => "Rx, Tx",
    }
}
