//! The entries of described objects.

use super::context::Context;
use super::ids::Siblings;
use super::objects::category;
use super::{facts, keys, numbered, values};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Access, Address, Category, DataType, Entry, Index, Mappable, Provenance, Trigger, Value};
use crate::raw::{Entity, ObjectEntity, RawAccess, RawEntry, RawFacts, RawMappable, RawTrigger};
use crate::source::Origin;

/// The one entry of an object with a single value.
pub(super) fn single(
    context: &mut Context<'_>,
    entity: &ObjectEntity,
    index: Index,
    name: &str,
) -> Option<Entry> {
    let written = Written { raw: &entity.value, shared: &RawEntry::default(), origin: &entity.object.origin };
    let address = Address { index, subindex: 0 };
    let mut entry = entry(context, &written, address, name)?;
    entry.source = None;
    Some(entry)
}

/// The entries of a record or an array with subindex 0 before them.
pub(super) fn several(context: &mut Context<'_>, entity: &ObjectEntity, index: Index) -> Option<Vec<Entry>> {
    let mut entries: Vec<Entry> = Vec::new();
    let mut ids = Siblings::default();
    for raw in &entity.entries {
        let at = raw.origin.header();
        let Some(range) = keys::range::<u8>(&raw.key) else {
            context.invalid(&raw.key, "a subindex from 0 to 255, or a range of them such as \"1..=16\"", at);
            continue;
        };
        let many = range.start() != range.end();
        if many {
            report_braces(context, raw);
        }
        for subindex in range {
            let address = Address { index, subindex };
            if let Some(other) = entries.iter().find(|entry| entry.address == address) {
                let message = format!("{address} is described twice");
                let fault = Diagnostic::new(&faults::DUPLICATE_INDEX, message, at, "here");
                context.diagnostics.push(fault.label(other.origin.header(), "and here"));
                continue;
            }
            let name = name(raw, subindex, many);
            let mut found = member(context, entity, raw, address, &name, &mut ids);
            if let Some(parameter) =
                found.as_mut().and_then(|entry| entry.parameter.as_mut()).filter(|_| many)
            {
                *parameter = numbered::of(parameter, subindex);
            }
            entries.extend(found);
        }
    }
    entries.sort_by_key(|entry| entry.address.subindex);
    if entries.first().is_none_or(|entry| entry.address.subindex != 0) {
        let highest = entries.last().map_or(0, |entry| entry.address.subindex);
        let mut count = count(index, highest, &entity.object.origin);
        count.functional = entity.value.functional.unwrap_or(true);
        entries.insert(0, count);
    }
    Some(entries)
}

/// Reports braces that stand for no number.
fn report_braces(context: &mut Context<'_>, raw: &Entity<RawEntry>) {
    for (key, text) in [("name", &raw.raw.name), ("parameter", &raw.raw.parameter)] {
        let braced = text.as_ref().filter(|text| text.contains('{'));
        if let Some(text) = braced.filter(|text| numbered::numbered(text, 1).is_none()) {
            context.invalid(text, "`{}`, or a signed number in braces such as `{+8}`", raw.origin.value(key));
        }
    }
}

fn name(raw: &Entity<RawEntry>, subindex: u8, many: bool) -> String {
    match &raw.raw.name {
        Some(name) if many && name.contains('{') => numbered::of(name, subindex),
        Some(name) if many => format!("{name} {subindex}"),
        Some(name) => name.clone(),
        None if subindex == 0 => COUNT.to_owned(),
        None => format!("Subindex {subindex:03}"),
    }
}

fn member(
    context: &mut Context<'_>,
    entity: &ObjectEntity,
    raw: &Entity<RawEntry>,
    address: Address,
    name: &str,
    ids: &mut Siblings,
) -> Option<Entry> {
    let none = RawEntry::default();
    let shared = if address.subindex == 0 { &none } else { &entity.value };
    let written = Written { raw: &raw.raw, shared, origin: &raw.origin };
    let mut entry = if address.subindex == 0 {
        described_count(context, &written, entity, address)?
    } else {
        entry(context, &written, address, name)?
    };
    entry.id = ids.claim(name);
    entry.functional &= entity.value.functional.unwrap_or(true);
    entry.source = own_source(context, &raw.facts, &entity.object.facts);
    Some(entry)
}

/// The source of an entry if it is not the object's.
fn own_source(context: &mut Context<'_>, own: &RawFacts, object: &RawFacts) -> Option<crate::model::Source> {
    own.source.as_ref().filter(|source| Some(*source) != object.source.as_ref())?;
    facts::source(context, own)
}

/// What was written of an entry: in its own table, and for all entries in the object's.
struct Written<'a> {
    raw: &'a RawEntry,
    shared: &'a RawEntry,
    origin: &'a Origin,
}

const COUNT: &str = "Highest subindex supported";

/// Subindex 0 as devc makes it.
pub(super) fn count(index: Index, highest: u8, origin: &Origin) -> Entry {
    let address = Address { index, subindex: 0 };
    let mut entry = plain(address, COUNT, DataType::Uint(8), origin);
    entry.default = Some(Value::Integer(highest.into()));
    entry
}

/// Subindex 0 where a description says something of it.
fn described_count(
    context: &mut Context<'_>,
    written: &Written<'_>,
    entity: &ObjectEntity,
    address: Address,
) -> Option<Entry> {
    let Written { raw, origin, .. } = written;
    let mut entry = count(address.index, highest(entity), origin);
    if raw.r#type.is_some() {
        entry.data_type = data_type(context, written, address)?;
        entry.type_provenance = context.provenance(origin, "type");
    }
    if let Some(default) = &raw.default {
        entry.default = values::value(context, default, entry.data_type, "default", origin);
    }
    entry.name = raw.name.clone().unwrap_or(entry.name);
    entry.access = access(raw.access);
    entry.note = raw.note.clone();
    entry.about = raw.about.clone();
    entry.written = raw.written.clone();
    entry.functional = raw.functional.unwrap_or(true);
    Some(entry)
}

fn highest(entity: &ObjectEntity) -> u8 {
    let ends = entity.entries.iter().filter_map(|entry| keys::range::<u8>(&entry.key));
    ends.map(|range| *range.end()).max().unwrap_or(0)
}

/// An entry that is read only and says nothing but its type.
pub(super) fn plain(address: Address, name: &str, data_type: DataType, origin: &Origin) -> Entry {
    Entry {
        address,
        id: super::ids::id(name),
        name: name.to_owned(),
        data_type,
        type_provenance: Provenance::Derived,
        access: Access::Ro,
        pdo: Mappable::None,
        category: Category::Mandatory,
        unit: None,
        default: None,
        min: None,
        max: None,
        values: Vec::new(),
        written: None,
        about: None,
        note: None,
        functional: true,
        trigger: None,
        parameter: None,
        source: None,
        origin: origin.clone(),
    }
}

fn entry(context: &mut Context<'_>, written: &Written<'_>, address: Address, name: &str) -> Option<Entry> {
    let Written { raw, shared, origin } = written;
    let data_type = data_type(context, written, address)?;
    let mut value = |literal: Option<&crate::raw::Literal>, key: &str| {
        literal.and_then(|literal| values::value(context, literal, data_type, key, origin))
    };
    let default = value(raw.default.as_ref().or(shared.default.as_ref()), "default");
    let min = value(raw.min.as_ref().or(shared.min.as_ref()), "min");
    let max = value(raw.max.as_ref().or(shared.max.as_ref()), "max");
    let is_count = address.subindex == 0;
    let trigger = raw.trigger.as_ref().and_then(|raw| trigger(context, raw, data_type, origin));
    Some(Entry {
        type_provenance: context.provenance(origin, "type"),
        access: access(raw.access.or(shared.access)),
        pdo: mappable(raw.pdo.or(shared.pdo)),
        category: category(raw.category.or(shared.category)),
        unit: raw.unit.clone().or_else(|| shared.unit.clone()),
        default,
        min,
        max,
        values: values::meanings(context, &raw.values, origin, "values"),
        written: raw.written.clone().or_else(|| shared.written.clone().filter(|_| !is_count)),
        about: raw.about.clone(),
        note: raw.note.clone(),
        functional: raw.functional.unwrap_or(true),
        trigger,
        parameter: raw.parameter.clone(),
        ..plain(address, name, data_type, origin)
    })
}

fn data_type(context: &mut Context<'_>, written: &Written<'_>, address: Address) -> Option<DataType> {
    let text = written.raw.r#type.as_ref().or(written.shared.r#type.as_ref());
    let Some(text) = text else {
        let message = format!("{address} has no type");
        let fault =
            Diagnostic::new(&faults::UNTYPED_ENTRY, message, written.origin.header(), "needs a `type`");
        context
            .diagnostics
            .push(fault.help("write one, such as `type = \"UINT16\"`; no profile knows this object"));
        return None;
    };
    let expected = "a data type such as BOOL, INT32, UINT16, REAL32, WORD or STRING(8)";
    match context.parse(text, expected, written.origin.value("type"))? {
        DataType::Text(0) => Some(DataType::Text(values::text_length(written.raw.default.as_ref()))),
        data_type => Some(data_type),
    }
}

fn trigger(
    context: &mut Context<'_>,
    raw: &RawTrigger,
    data_type: DataType,
    origin: &Origin,
) -> Option<Trigger> {
    Some(Trigger {
        value: values::value(context, &raw.value, data_type, "trigger.value", origin)?,
        action: raw.action.clone(),
        mode: raw.mode,
        uses: context.addresses(&raw.uses, origin, "trigger.uses"),
        updates: context.addresses(&raw.updates, origin, "trigger.updates"),
    })
}

pub(super) fn access(raw: Option<RawAccess>) -> Access {
    match raw {
        Some(RawAccess::Rw) => Access::Rw,
        Some(RawAccess::Wo) => Access::Wo,
        Some(RawAccess::Const) => Access::Const,
        Some(RawAccess::Ro) | None => Access::Ro,
    }
}

fn mappable(raw: Option<RawMappable>) -> Mappable {
    match raw {
        Some(RawMappable::Rx) => Mappable::Rx,
        Some(RawMappable::Tx) => Mappable::Tx,
        Some(RawMappable::RxTx) => Mappable::RxTx,
        Some(RawMappable::None) | None => Mappable::None,
    }
}
