//! The dictionary: what SDOs are called, and what values in process data are.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::emit::escape::prose;
use crate::emit::identifier::{Claimed, snake};
use crate::emit::program::{Kind, of_type};
use crate::emit::steps;
use crate::model::{Address, DataType, Device, Entry as Described, Mappable, Mapped, Object, Unit, Word};

/// The first and the last of values, with what they mean.
pub(super) type Meaning = (i64, i64, String);

/// An object.
#[derive(Debug, Serialize)]
pub(super) struct Named {
    index: u16,
    title: String,
}

/// An entry.
#[derive(Debug, Serialize)]
pub(super) struct Entry {
    /// Index and subindex as one number.
    key: u32,
    title: String,
    kind: &'static str,
    bits: u32,
    /// The last part of the filter that process data is found by; none if it cannot be process data.
    filter: Option<String>,
    axis: Option<u8>,
    word: Option<String>,
    unit: Option<String>,
    /// The list that says what values mean, where it is one of the device.
    named: Option<&'static str>,
    values: Vec<Meaning>,
}

/// The objects and their entries, and what is mapped although the dictionary does not have it.
pub(super) fn dictionary(device: &Device) -> (Vec<Named>, Vec<Entry>) {
    let title = |object: &Object| prose(&device.on_axis(&object.name, object.axis));
    let objects = device.objects.iter().map(|it| Named { index: it.index.0, title: title(it) });
    let (mapped, mut filters) = (mapped(device), Claimed::default());
    let known = Known::of(device);
    let mut entries = Vec::new();
    for object in &device.objects {
        for it in &object.entries {
            let title = if object.entries.len() == 1 { title(object) } else { prose(&it.name) };
            let can_be = it.pdo != Mappable::None || mapped.contains_key(&it.address);
            let filter = can_be.then(|| claimed(&mut filters, path(device, object, it)));
            entries.push(entry(&known, object, it, title, filter));
        }
    }
    for (address, it) in mapped.iter().filter(|(address, _)| device.entry(**address).is_none()) {
        let filter = claimed(&mut filters, vec![part(&it.id)]);
        let (kind, _) = of_type(it.data_type, it.bits, false);
        entries.push(Entry {
            key: key(*address),
            title: prose(&it.name),
            kind: word_for(kind, it.data_type),
            bits: it.bits,
            filter: Some(filter),
            axis: None,
            word: None,
            unit: None,
            named: None,
            values: Vec::new(),
        });
    }
    (objects.collect(), entries)
}

/// What is mapped by default and by configurations, each address once.
fn mapped(device: &Device) -> BTreeMap<Address, &Mapped> {
    let chosen = device.configurations.iter().flat_map(|it| &it.mapping);
    let pdos = device.pdos.iter().chain(chosen);
    let mapped = pdos.flat_map(|pdo| &pdo.entries).filter_map(|it| Some((it.address?, it)));
    mapped.collect()
}

/// What entries refer to, by how they do.
struct Known<'d> {
    words: BTreeMap<Address, &'d Word>,
    units: BTreeMap<&'d str, &'d Unit>,
}

impl<'d> Known<'d> {
    fn of(device: &'d Device) -> Self {
        Self {
            words: device.words.iter().rev().map(|word| (word.address, word)).collect(),
            units: device.units.iter().rev().map(|unit| (&*unit.id, unit)).collect(),
        }
    }
}

fn entry(known: &Known<'_>, object: &Object, of: &Described, title: String, filter: Option<String>) -> Entry {
    // a word stands once for all axes
    let word = known.words.get(&Address { index: object.leading, ..of.address });
    let (kind, _) = of_type(Some(of.data_type), of.data_type.bits(), word.is_some());
    let unit = of.unit.as_deref().and_then(|unit| steps::on(known.units.get(unit)?, object.axis));
    let named = match (object.leading.0, of.address.subindex) {
        (0x6060 | 0x6061, 0) => Some("MODES"),
        (0x603F, 0) => Some("ERRORS"),
        _ => None,
    };
    Entry {
        key: key(of.address),
        title,
        kind: word_for(kind, Some(of.data_type)),
        bits: of.data_type.bits(),
        filter,
        axis: object.axis,
        word: word.map(|word| word.id.clone()),
        unit: unit.map(|unit| prose(&unit)),
        named,
        values: of.values.iter().map(|it| (it.value, it.value, prose(&it.name))).collect(),
    }
}

fn key(address: Address) -> u32 {
    u32::from(address.index.0) * 256 + u32::from(address.subindex)
}

/// What the dissector calls a kind.
fn word_for(kind: Kind, data_type: Option<DataType>) -> &'static str {
    match (kind, data_type) {
        (_, Some(DataType::Text(_))) => "text",
        (Kind::Bool, _) => "bool",
        (Kind::Int, _) => "int",
        (Kind::Uint, _) => "uint",
        (Kind::Real, _) => "real",
        (Kind::Bytes, _) => "bytes",
    }
}

/// Axis where there are several, object, and entry where there are several.
fn path(device: &Device, object: &Object, entry: &Described) -> Vec<String> {
    let axis = object.axis.filter(|_| device.axes.len() > 1);
    let axis = axis.and_then(|axis| device.axes.get(usize::from(axis))).map(|axis| part(&axis.name));
    let own = (object.entries.len() > 1).then(|| part(&entry.id));
    axis.into_iter().chain([part(&object.id)]).chain(own).collect()
}

/// A part of a filter: lower case, and no digit first.
fn part(id: &str) -> String {
    match snake(id) {
        name if name.is_empty() => "unnamed".to_owned(),
        name if name.starts_with(|c: char| c.is_ascii_digit()) => format!("n{name}"),
        name => name,
    }
}

/// Filters that the dissector has of its own.
const OWN: [&str; 5] = ["station", "mismatch", "sdo", "emergency", "al"];

fn claimed(taken: &mut Claimed, parts: Vec<String>) -> String {
    let mut name = parts.join(".");
    if parts.first().is_some_and(|first| OWN.contains(&first.as_str())) {
        name.insert_str(0, "object.");
    }
    taken.claim(name.clone(), |number| format!("{name}_{number}"))
}
