//! The table of an area: a line for each value.

use super::{detail, is_mapping};
use crate::emit::markdown::context::{Context, is_single};
use crate::emit::markdown::inline::{anchor, code, link, text};
use crate::emit::markdown::table::Table;
use crate::model::{Access, DataType, Entry, Kind, Mappable, Object, Value};

/// The table of these objects. Subindex 0 of a record has a line only if it is not simply the highest
/// subindex, and a mapping object has no lines for its entries.
pub(super) fn table(context: &Context<'_>, objects: &[&Object]) -> Table {
    let mut table = Table::new(["Index", "Name", "Type", "Access", "PDO", "Default", "Unit", "Range"]);
    for object in objects {
        match object.entries.as_slice() {
            [only] if is_single(object) => table.row(single(context, object, only)),
            entries => {
                table.row(head(context, object));
                let shown =
                    entries.iter().filter(|entry| !is_mapping(context, object) && !is_count(object, entry));
                shown.for_each(|entry| table.row(nested(context, object, entry)));
            }
        }
    }
    table
}

/// Whether an entry is subindex 0 as it is in every record: the highest subindex, for reading.
pub(super) fn is_count(object: &Object, entry: &Entry) -> bool {
    let plain = entry.data_type == DataType::Uint(8) && !entry.access.writable();
    let highest = entry.default == Some(Value::Integer(object.highest_subindex().into()));
    !is_single(object) && entry.address.subindex == 0 && plain && highest
}

fn single(context: &Context<'_>, object: &Object, entry: &Entry) -> [String; 8] {
    let [data_type, access, pdo, default, unit, range] = facts(context, object, entry);
    [index(context, object), strong(&object.name), data_type, access, pdo, default, unit, range]
}

fn head(context: &Context<'_>, object: &Object) -> [String; 8] {
    let kind = match object.kind {
        Kind::Var => "",
        Kind::Array => "*array*",
        Kind::Record => "*record*",
    };
    let empty = String::new;
    [index(context, object), strong(&object.name), kind.into(), empty(), empty(), empty(), empty(), empty()]
}

fn nested(context: &Context<'_>, object: &Object, entry: &Entry) -> [String; 8] {
    let [data_type, access, pdo, default, unit, range] = facts(context, object, entry);
    let subindex = format!("&emsp;{}", code(format!(":{:02X}", entry.address.subindex)));
    [subindex, text(&entry.name), data_type, access, pdo, default, unit, range]
}

fn facts(context: &Context<'_>, object: &Object, entry: &Entry) -> [String; 6] {
    [
        entry.data_type.to_string(),
        access(entry.access).into(),
        mappable(entry.pdo).into(),
        context.default(entry),
        context.unit(entry, object.axis),
        context.range(entry),
    ]
}

/// The index, as a link to what else there is to say or as the place that links lead to.
fn index(context: &Context<'_>, object: &Object) -> String {
    let label = code(object.index);
    if is_mapping(context, object) {
        return context.index(object.index);
    }
    match detail::detail(context, object) {
        Some(_) => link(label, context.object_id(object)),
        None => format!("{}{label}", anchor(context.object_id(object))),
    }
}

fn strong(name: &str) -> String {
    format!("**{}**", text(name))
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
