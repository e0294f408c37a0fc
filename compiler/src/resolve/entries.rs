//! The entries of described objects.

use super::context::Context;
use super::{numbered, values};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::ids::{self, Siblings};
use crate::model::{
    Access, Address, Category, DataType, Entry, Index, Literal, Mappable, Meanings, Translations, Trigger,
    Value,
};
use crate::raw::{RawEntries, RawEntry, RawObject, RawTrigger};
use crate::source::{Location, Origin};

/// The one entry of an object with a single value.
pub(super) fn single(context: &mut Context<'_>, raw: &RawObject, index: Index, name: &str) -> Option<Entry> {
    let known = Known { address: Address { index, subindex: 0 }, name, data_type: None, many: false };
    entry(context, known, &raw.value, &raw.origin)
}

/// The entries of a record or an array with subindex 0 before them.
pub(super) fn several(context: &mut Context<'_>, raw: &RawObject, index: Index) -> Option<Vec<Entry>> {
    let mut entries: Vec<Entry> = Vec::new();
    let mut ids = Siblings::default();
    for described in &raw.entries {
        let (first, last) = described.range;
        if described.many {
            report_braces(context, described);
        }
        for subindex in first..=last {
            let address = Address { index, subindex };
            if let Some(other) = entries.iter().find(|entry| entry.address == address) {
                let message = format!("{address} is described twice");
                let fault =
                    Diagnostic::new(&faults::DUPLICATE_INDEX, message, described.origin.header(), "here");
                context.diagnostics.push(fault.label(other.origin.header(), "and here"));
                continue;
            }
            entries.extend(member(context, raw, described, address, &mut ids));
        }
    }
    entries.sort_by_key(|entry| entry.address.subindex);
    if entries.first().is_none_or(|entry| entry.address.subindex != 0) {
        let mut count = count(index, highest(raw), &raw.origin);
        count.functional = raw.value.functional.unwrap_or(true);
        entries.insert(0, count);
    }
    Some(entries)
}

/// Reports braces that stand for no number.
fn report_braces(context: &mut Context<'_>, raw: &RawEntries) {
    for (key, text) in [("name", &raw.value.name), ("parameter", &raw.value.parameter)] {
        let braced = text.as_ref().filter(|text| text.contains('{'));
        if let Some(text) = braced.filter(|text| numbered::numbered(text, 1).is_none()) {
            context.invalid(
                text,
                "`{}`, or a signed number in braces such as `{+8}` or `{-1:02}`",
                raw.origin.value(key),
            );
        }
    }
}

fn name(raw: &RawEntries, subindex: u8) -> String {
    let many = raw.many;
    match &raw.value.name {
        Some(name) if many => numbered::name(name, subindex),
        Some(name) => name.clone(),
        None if subindex == 0 => Entry::COUNT.to_owned(),
        None => format!("Subindex {subindex:03}"),
    }
}

fn member(
    context: &mut Context<'_>,
    object: &RawObject,
    raw: &RawEntries,
    address: Address,
    ids: &mut Siblings,
) -> Option<Entry> {
    let is_count = address.subindex == 0;
    let name = name(raw, address.subindex);
    let data_type = is_count.then_some(DataType::Uint(8));
    let known = Known { address, name: &name, data_type, many: raw.many };
    let mut entry = entry(context, known, &raw.value, &raw.origin)?;
    entry.id = ids.claim(&name);
    let of_object = || numbered::numbered(object.value.parameter.as_deref()?, address.subindex);
    entry.parameter = entry.parameter.or_else(|| of_object().filter(|_| !is_count));
    if is_count {
        entry.default = entry.default.or_else(|| Some(Value::Integer(highest(object).into())));
        entry.category = raw.value.category.unwrap_or(Category::Mandatory);
        entry.functional = raw.value.functional.or(object.value.functional).unwrap_or(true);
    }
    entry.source = raw.source.clone().filter(|source| Some(source) != object.source.as_ref());
    Some(entry)
}

/// Subindex 0 as devc makes it.
pub(super) fn count(index: Index, highest: u8, origin: &Origin) -> Entry {
    let address = Address { index, subindex: 0 };
    let mut entry = plain(address, Entry::COUNT, DataType::Uint(8), origin);
    entry.default = Some(Value::Integer(highest.into()));
    entry
}

fn highest(raw: &RawObject) -> u8 {
    raw.entries.iter().map(|entries| entries.range.1).max().unwrap_or(0)
}

/// An entry that devc makes: read only, and nothing but its type is said. What it follows from stands at `origin`.
pub(super) fn plain(address: Address, name: &str, data_type: DataType, origin: &Origin) -> Entry {
    Entry {
        address,
        id: ids::id(name),
        name: name.to_owned(),
        names: Translations::default(),
        data_type,
        access: Access::Ro,
        pdo: Mappable::None,
        safety: None,
        category: Category::Mandatory,
        unit: None,
        default: None,
        min: None,
        max: None,
        values: Meanings::default(),
        written: None,
        backup: false,
        setting: false,
        effective: None,
        stored: None,
        about: None,
        note: None,
        functional: true,
        trigger: None,
        parameter: None,
        properties: Vec::new(),
        source: None,
        origin: origin.header_only(),
    }
}

/// What is known of an entry before its table is looked at.
pub(super) struct Known<'a> {
    pub(super) address: Address,
    pub(super) name: &'a str,
    /// The type that it has if its table names none.
    pub(super) data_type: Option<DataType>,
    /// Whether its table describes others, too.
    pub(super) many: bool,
}

/// An entry as its table describes it. Each key of the table is looked at here, and nowhere else.
pub(super) fn entry(
    context: &mut Context<'_>,
    known: Known<'_>,
    raw: &RawEntry,
    origin: &Origin,
) -> Option<Entry> {
    #[rustfmt::skip] // a line for what belongs together
    let RawEntry {
        name: _, names, r#type, access, pdo, safety, category, unit,
        default, min, max, values,
        written, backup, setting, effective, stored,
        about, note, functional, trigger, parameter, properties,
    } = raw;
    let Known { address, name, data_type, many } = known;
    let data_type =
        self::data_type(context, address, r#type.as_deref(), data_type, default.as_ref(), origin)?;
    let counts = many.then_some(address.subindex);
    let mut value =
        |literal: &Option<Literal>, key| counted(context, literal.as_ref()?, counts, data_type, key, origin);
    let (default, min, max) = (value(default, "default"), value(min, "min"), value(max, "max"));
    let numbered = |parameter: &String| numbered::of(parameter, address.subindex);
    Some(Entry {
        address,
        id: ids::id(name),
        name: name.to_owned(),
        names: if many { numbered::names(names, address.subindex) } else { names.clone() },
        data_type,
        access: access.unwrap_or_default(),
        pdo: pdo.unwrap_or_default(),
        safety: *safety,
        category: category.unwrap_or_default(),
        unit: unit.clone(),
        default,
        min,
        max,
        values: values.as_ref().map(|values| context.meanings(values)).unwrap_or_default(),
        written: *written,
        backup: backup.unwrap_or_default(),
        setting: setting.unwrap_or_default(),
        effective: *effective,
        stored: *stored,
        about: about.clone(),
        note: note.clone(),
        functional: functional.unwrap_or(true),
        trigger: trigger.as_ref().and_then(|raw| self::trigger(context, raw, data_type, origin)),
        parameter: if many { parameter.as_ref().map(numbered) } else { parameter.clone() },
        properties: properties.clone(),
        source: None,
        origin: origin.clone(),
    })
}

/// A value as it is written, or as it is for one of several entries.
fn counted(
    context: &mut Context<'_>,
    literal: &Literal,
    subindex: Option<u8>,
    data_type: DataType,
    key: &str,
    origin: &Origin,
) -> Option<Value> {
    let literal = match subindex {
        Some(subindex) => numbered::value(literal, subindex, data_type),
        None => literal.clone(),
    };
    values::value(context, &literal, data_type, [key, "type"].map(|key| origin.value(key)))
}

fn data_type(
    context: &mut Context<'_>,
    address: Address,
    text: Option<&str>,
    known: Option<DataType>,
    default: Option<&Literal>,
    origin: &Origin,
) -> Option<DataType> {
    let Some(text) = text else {
        if known.is_none() {
            let message = format!("{address} has no type");
            let fault = Diagnostic::new(&faults::UNTYPED_ENTRY, message, origin.header(), "needs a `type`");
            let help = "write one, such as `type = \"UINT16\"`; no profile knows this object";
            context.diagnostics.push(fault.help(help));
        }
        return known;
    };
    match text.parse() {
        Ok(DataType::Text(0)) => Some(DataType::Text(values::text_length(default))),
        Ok(data_type) => Some(data_type),
        Err(()) => {
            let fault = unknown_type(text, origin.value("type"));
            context.diagnostics.push(fault);
            None
        }
    }
}

/// Reports a type that there is not, with devc's name for it if it has one elsewhere.
fn unknown_type(text: &str, at: Location) -> Diagnostic {
    let expected = "expected a data type such as BOOL, INT32, UINT16, REAL32, WORD or STRING(8)";
    let fault = Diagnostic::new(&faults::INVALID_VALUE, format!("`{text}` means nothing here"), at, expected);
    match DataType::named_elsewhere(text) {
        Some(meant) => fault.fix(format!("here it is `{meant}`"), at, format!("\"{meant}\"")),
        None => fault,
    }
}

fn trigger(
    context: &mut Context<'_>,
    raw: &RawTrigger,
    data_type: DataType,
    origin: &Origin,
) -> Option<Trigger> {
    let RawTrigger { value, action, mode, uses, updates } = raw;
    Some(Trigger {
        value: values::value(
            context,
            value,
            data_type,
            ["trigger.value", "type"].map(|key| origin.value(key)),
        )?,
        action: action.clone(),
        mode: *mode,
        uses: context.addresses(uses, origin, "trigger.uses"),
        updates: context.addresses(updates, origin, "trigger.updates"),
    })
}
