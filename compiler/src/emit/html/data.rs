//! What the decoders of the page have to know, of each member.

use serde::Serialize;

use crate::model::{Device, Family, Field, Meaning};

/// The data of a page.
#[derive(Debug, Serialize)]
pub(super) struct Data {
    members: Vec<Member>,
}

#[derive(Debug, Serialize)]
struct Member {
    id: String,
    name: String,
    axes: Vec<String>,
    words: Vec<Word>,
    states: Vec<State>,
    modes: Vec<Mode>,
    errors: Vec<Code>,
    vendor_codes: Vec<Code>,
    al_status_codes: Vec<Code>,
    pdos: Vec<Pdo>,
    units: Vec<Unit>,
}

#[derive(Debug, Serialize)]
struct Word {
    id: String,
    name: String,
    bits: u32,
    fields: Vec<Bits>,
}

/// Bits with a meaning, the lowest and the highest counted from 0.
#[derive(Debug, Serialize)]
struct Bits {
    low: u8,
    high: u8,
    name: String,
    reserved: bool,
    values: Vec<(i64, String)>,
}

/// A state is shown by the words of which the bits in `mask` are `value`.
#[derive(Debug, Serialize)]
struct State {
    name: String,
    mask: u16,
    value: u16,
}

/// What the bits of the words are in a mode.
#[derive(Debug, Serialize)]
struct Mode {
    code: i16,
    name: String,
    control: Vec<Bits>,
    status: Vec<Bits>,
}

/// A code, or a range of codes.
#[derive(Debug, Serialize)]
struct Code {
    first: u32,
    last: u32,
    name: String,
    about: Option<String>,
    remedy: Option<String>,
}

#[derive(Debug, Serialize)]
struct Pdo {
    index: String,
    name: String,
    bits: u32,
    fields: Vec<Mapped>,
}

#[derive(Debug, Serialize)]
struct Mapped {
    address: String,
    name: String,
    offset: u32,
    bits: u32,
    data_type: Option<String>,
    unit: Option<String>,
    axis: u8,
}

#[derive(Debug, Serialize)]
struct Unit {
    id: String,
    quantity: String,
    axes: Vec<AxisUnit>,
}

/// So many raw steps are so many units.
#[derive(Debug, Serialize)]
struct AxisUnit {
    symbol: String,
    raw: Option<u64>,
    units: Option<u64>,
}

impl Data {
    /// The data of a family.
    pub(super) fn of(family: &Family) -> Self {
        Self { members: family.members.iter().map(member).collect() }
    }
}

fn member(device: &Device) -> Member {
    let words = device.words.iter().map(|word| Word {
        id: word.id.clone(),
        name: word.name.clone(),
        bits: word.bits,
        fields: bits(&word.fields),
    });
    let states = device.states.iter().filter_map(|state| {
        let pattern = state.pattern.as_ref()?;
        Some(State { name: state.name.clone(), mask: pattern.mask(), value: pattern.value() })
    });
    let modes = device.modes.iter().map(|mode| Mode {
        code: mode.code,
        name: mode.name.clone(),
        control: bits(&mode.control_bits),
        status: bits(&mode.status_bits),
    });
    Member {
        id: device.id.clone(),
        name: device.name.clone(),
        axes: device.axes.iter().map(|axis| axis.name.clone()).collect(),
        words: words.collect(),
        states: states.collect(),
        modes: modes.collect(),
        errors: errors(device),
        vendor_codes: vendor_codes(device),
        al_status_codes: al_status_codes(device),
        pdos: pdos(device),
        units: units(device),
    }
}

fn bits(fields: &[Field]) -> Vec<Bits> {
    let value = |meaning: &Meaning| (i64::from(meaning.value), meaning.name.clone());
    let bits = fields.iter().map(|field| Bits {
        low: field.low,
        high: field.high,
        name: field.name.clone(),
        reserved: field.reserved,
        values: field.values.iter().map(value).collect(),
    });
    bits.collect()
}

fn errors(device: &Device) -> Vec<Code> {
    let codes = device.errors.iter().map(|error| Code {
        first: error.code.into(),
        last: error.last.into(),
        name: error.name.clone(),
        about: error.about.clone(),
        remedy: error.remedy.clone(),
    });
    codes.collect()
}

fn vendor_codes(device: &Device) -> Vec<Code> {
    let codes = device.vendor_codes.iter().map(|code| Code {
        first: code.code,
        last: code.code,
        name: code.name.clone(),
        about: code.about.clone(),
        remedy: None,
    });
    codes.collect()
}

fn al_status_codes(device: &Device) -> Vec<Code> {
    let codes = device.al_status_codes.iter().map(|status| Code {
        first: status.code.into(),
        last: status.code.into(),
        name: status.name.clone(),
        about: status.about.clone(),
        remedy: None,
    });
    codes.collect()
}

fn pdos(device: &Device) -> Vec<Pdo> {
    let pdos = device.pdos.iter().map(|pdo| {
        let fields = pdo.entries.iter().map(|mapped| {
            let entry = mapped.address.and_then(|address| device.entry(address));
            Mapped {
                address: mapped.address.map_or(String::new(), |address| address.to_string()),
                name: mapped.name.clone(),
                offset: mapped.offset,
                bits: mapped.bits,
                data_type: mapped.data_type.map(|data_type| data_type.to_string()),
                unit: entry.and_then(|entry| entry.unit.clone()),
                axis: pdo.axis.unwrap_or(0),
            }
        });
        Pdo {
            index: pdo.index.to_string(),
            name: pdo.name.clone(),
            bits: pdo.bits(),
            fields: fields.collect(),
        }
    });
    pdos.collect()
}

fn units(device: &Device) -> Vec<Unit> {
    let units = device.units.iter().map(|unit| {
        let axes = unit.axes.iter().map(|axis| AxisUnit {
            symbol: axis.symbol.clone(),
            raw: axis.scale.map(|scale| scale.raw),
            units: axis.scale.map(|scale| scale.units),
        });
        Unit { id: unit.id.clone(), quantity: unit.quantity.clone(), axes: axes.collect() }
    });
    units.collect()
}
