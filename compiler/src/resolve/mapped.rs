//! What a PDO carries, laid out bit by bit.

use std::borrow::Cow;
use std::sync::Arc;

use super::context::Context;
use super::{names, numbered, objects};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::ids::{self, Siblings};
use crate::model::{Address, DataType, Entry, Mapped, Object, Pdo};
use crate::raw::RawMapped;
use crate::source::{Key, Layer, Location, Member, Origin, Table, keys};

/// What a sync manager can carry: its length is a number of bytes in 16 bits.
const MAX_BITS: u32 = u16::MAX as u32 * 8;

/// What is mapped, each entry behind the one before.
pub(super) fn mapped(
    context: &mut Context<'_>,
    raw: &[RawMapped],
    origin: &Origin,
    path: &str,
    axis: Option<u8>,
    objects: &[Object],
) -> Vec<Mapped> {
    let mut offset = 0;
    let mut ids = Siblings::default();
    let mut entries = Vec::new();
    let places = raw.iter().enumerate().map(|(i, entry)| (place(origin, path, i), entry));
    let spans = places
        .flat_map(|(place, entry)| span(context, entry, objects).map(move |entry| (place.clone(), entry)));
    let all: Vec<_> = spans.collect();
    for (i, (place, entry)) in all.iter().enumerate() {
        let at = place.header();
        if i == Pdo::ROOM {
            let message = format!("{} entries do not fit a PDO", all.len());
            context.fault(
                &faults::UNFIT_VALUE,
                message,
                at,
                &format!("a mapping object holds {}", Pdo::ROOM),
            );
            break;
        }
        if let Some(found) = one(context, entry, place, axis, objects) {
            let mapped = Mapped { offset, id: ids.claim(&found.id), ..found };
            offset += mapped.bits;
            entries.push(mapped);
            if offset > MAX_BITS {
                let message = format!("{} bits and more do not fit a PDO", offset);
                context.fault(&faults::UNFIT_VALUE, message, at, "too much with what stands before");
                break;
            }
        }
    }
    entries
}

/// What a list says in one place, as a table.
fn place(origin: &Origin, path: &str, i: usize) -> Origin {
    let Some(node) = origin.node(&format!("{path}.{i}")) else { return origin.header_only() };
    let entry = || {
        let layer = origin.layer(path).unwrap_or(Layer::Description);
        let entry = Member { key: Key::new("entry", node.at), node: node.clone(), layer, under: None };
        Arc::new(Table { at: node.at, members: vec![entry].into() })
    };
    Origin::new(node.at, node.table().map_or_else(entry, Arc::clone))
}

fn one(
    context: &mut Context<'_>,
    raw: &RawMapped,
    origin: &Origin,
    axis: Option<u8>,
    objects: &[Object],
) -> Option<Mapped> {
    let at = origin.header();
    let padding = Mapped {
        address: None,
        name: raw.name.clone().unwrap_or_else(|| Mapped::PADDING.to_owned()),
        names: raw.names.clone(),
        id: "padding".to_owned(),
        offset: 0,
        bits: raw.bits.unwrap_or(0).into(),
        data_type: None,
        own_type: None,
        about: raw.about.clone(),
        origin: origin.clone(),
    };
    let Some(text) = &raw.entry else {
        typeless(context, raw, "padding has no type", at);
        return Some(padding);
    };
    let address = context.names.find(text).ok().map(|address| context.on_axis(address, axis));
    let entry = address.and_then(|address| find(objects, address));
    if let Some((object, _)) = entry.filter(|(object, _)| object.entries.len() > 1)
        && context.names.whole(text).is_some()
    {
        if axis.is_none_or(|axis| axis == 0) {
            context.several_entries(text, object, at);
        }
        return None;
    }
    let known = entry.map(|(_, entry)| entry.data_type);
    let data_type = stated(context, raw, known, at);
    let bits = raw.bits.map(u32::from).or(data_type.map(DataType::bits));
    match (entry, absent(context, text, axis), bits) {
        (Some(known), ..) => Some(Mapped { address, own_type: data_type, ..of_entry(raw, known, padding) }),
        (None, Some(address), Some(bits)) => {
            let name = raw.name.clone().unwrap_or_else(|| address.to_string());
            Some(Mapped { address: Some(address), id: ids::id(&name), name, bits, data_type, ..padding })
        }
        _ => {
            // Once is enough: what is not there on the first axis is not there on the others.
            if let Some(address) = context.address(text, at)
                && axis.is_none_or(|axis| axis == 0)
            {
                match objects::at(objects, address.index) {
                    Some(object) => context.no_entry(object, address, at),
                    None => unmappable(context, address, at),
                }
            }
            None
        }
    }
}

/// Reports that an object is mapped which is made only when all PDOs are known.
fn unmappable(context: &mut Context<'_>, address: Address, at: Location) {
    let message = format!("{address} cannot be in a PDO");
    let label = "what is mapped and assigned stands there, which follows from the PDOs";
    let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, label);
    context
        .diagnostics
        .push(fault.help("leave it out, or say its `type` if the device maps it all the same"));
}

/// An entry of the dictionary as it is mapped; `bare` is what is known without it.
fn of_entry(raw: &RawMapped, (object, entry): (&Object, &Entry), bare: Mapped) -> Mapped {
    let single = object.entries.len() == 1;
    let (name, names) = if single { (&object.name, &object.names) } else { (&entry.name, &entry.names) };
    let has_own = raw.name.is_some() || !raw.names.is_empty();
    Mapped {
        name: raw.name.clone().unwrap_or_else(|| name.clone()),
        names: if has_own { raw.names.clone() } else { names.clone() },
        id: if single { object.id.clone() } else { format!("{}-{}", object.id, entry.id) },
        bits: raw.bits.map_or(entry.data_type.bits(), u32::from),
        data_type: Some(entry.data_type),
        ..bare
    }
}

/// The type that is said of what is mapped. What is in the dictionary has one there, and can only be told as another one
/// that is as wide.
fn stated(
    context: &mut Context<'_>,
    raw: &RawMapped,
    known: Option<DataType>,
    at: Location,
) -> Option<DataType> {
    let text = raw.r#type.as_deref()?;
    match text.parse() {
        Ok(data_type) if known.is_some_and(|known| known.bits() != DataType::bits(data_type)) => {
            typeless(context, raw, "what is in the dictionary has another width there", at);
            None
        }
        Ok(data_type) if DataType::bits(data_type) > 0 => Some(data_type),
        _ => {
            // The place is that of the whole entry, which no fix may take the place of.
            let expected = "expected a data type such as INT32, UINT16, REAL32, WORD or STRING(8)";
            let message = format!("`{text}` means nothing here");
            let fault = Diagnostic::new(&faults::INVALID_VALUE, message, at, expected);
            let meant = DataType::named_elsewhere(text).filter(|meant| meant.bits() > 0);
            context.diagnostics.push(match meant {
                Some(meant) => fault.help(format!("here it is `{meant}`")),
                None => fault,
            });
            None
        }
    }
}

/// Reports a type of what cannot be said to have one.
fn typeless(context: &mut Context<'_>, raw: &RawMapped, why: &str, at: Location) {
    if raw.r#type.is_some() {
        context.fault(&faults::UNFIT_VALUE, why.to_owned(), at, "leave the `type` out");
    }
}

/// What a range of entries stands for, `"0x2003:01..=10"`: each of them. Subindices are hexadecimal as in other references;
/// a range that the object has only if it is written as the keys of its `entries` is meant like these.
fn span<'r>(
    context: &Context<'_>,
    raw: &'r RawMapped,
    objects: &[Object],
) -> impl Iterator<Item = Cow<'r, RawMapped>> + use<'r> {
    let range = raw.entry.as_deref().and_then(|text| {
        let (object, range) = text.split_once(':').filter(|(_, range)| range.contains("..="))?;
        let index = context.names.whole(object)?;
        let last = objects::at(objects, index).map_or(u8::MAX, Object::highest_subindex);
        let (first, end) = range.split_once("..=")?;
        let hexadecimal =
            names::subindex(first).zip(names::subindex(end)).filter(|(first, end)| first <= end);
        let as_key = keys::range::<u8>(range).map(|range| (*range.start(), *range.end()));
        let fits = |range: &(u8, u8)| range.1 <= last;
        let (first, end) = hexadecimal.filter(fits).or(as_key.filter(fits)).or(hexadecimal)?;
        Some((object.to_owned(), first..=end))
    });
    let each = range.map(|(object, range)| {
        range.map(move |subindex| {
            let entry = Some(format!("{object}:{subindex:02X}"));
            let name = raw.name.as_ref().map(|name| numbered::name(name, subindex));
            let names = numbered::names(&raw.names, subindex);
            Cow::Owned(RawMapped { entry, name, names, ..raw.clone() })
        })
    });
    let alone = each.is_none().then_some(Cow::Borrowed(raw));
    each.into_iter().flatten().chain(alone)
}

fn find(objects: &[Object], address: Address) -> Option<(&Object, &Entry)> {
    let object = objects::at(objects, address.index)?;
    object.entry(address.subindex).map(|entry| (object, entry))
}

/// The address of something that a manual maps although its dictionary does not have it.
fn absent(context: &Context<'_>, text: &str, axis: Option<u8>) -> Option<Address> {
    let (index, subindex) = text.split_once(':').unwrap_or((text, "0"));
    let index = names::index(index)?;
    let subindex = names::subindex(subindex)?;
    Some(context.on_axis(Address { index, subindex }, axis))
}
