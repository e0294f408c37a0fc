//! What the decoders of the page have to know, of each member.

mod pdo;

use std::collections::BTreeMap;

use pdo::Pdo;
use serde::Serialize;

use super::abort;
use crate::model::{Device, Family, Field, Index, Meaning};

/// The data of a page.
#[derive(Debug, Serialize)]
pub(super) struct Data {
    members: Vec<Member>,
    /// The same for all devices.
    abort_codes: Vec<Code>,
}

#[derive(Debug, Serialize)]
struct Member {
    id: String,
    name: String,
    axes: Vec<String>,
    words: Vec<Word>,
    states: Vec<State>,
    asked: Vec<Asked>,
    modes: Vec<Mode>,
    errors: Vec<Code>,
    vendor_codes: Vec<Code>,
    al_status_codes: Vec<Code>,
    pdos: Vec<Pdo>,
    units: Vec<Unit>,
    /// The indices on each axis, by that on the first.
    repeats: BTreeMap<String, Vec<Option<String>>>,
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

/// What controlwords ask for of which the bits in `mask` are `value`, if those of `rising` were 0 before and those of
/// `falling` 1.
#[derive(Debug, Serialize)]
struct Asked {
    name: String,
    mask: u16,
    value: u16,
    rising: u16,
    falling: u16,
    transitions: Vec<u8>,
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
        let abort = |(code, name): &(u32, &str)| Code {
            first: *code,
            last: *code,
            name: (*name).to_owned(),
            about: None,
            remedy: None,
        };
        Self {
            members: family.members.iter().map(member).collect(),
            abort_codes: abort::CODES.iter().map(abort).collect(),
        }
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
        asked: asked(device),
        modes: modes.collect(),
        errors: errors(device),
        vendor_codes: vendor_codes(device),
        al_status_codes: al_status_codes(device),
        pdos: device.pdos.iter().map(|pdo| Pdo::of(device, pdo)).collect(),
        units: units(device),
        repeats: repeats(device),
    }
}

fn asked(device: &Device) -> Vec<Asked> {
    let asked = device.given().map(|given| Asked {
        name: given.name(),
        mask: given.pattern().mask(),
        value: given.pattern().value(),
        rising: given.pattern().rising(),
        falling: given.pattern().falling(),
        transitions: device.set_off(given),
    });
    asked.collect()
}

fn repeats(device: &Device) -> BTreeMap<String, Vec<Option<String>>> {
    let hex = |index: Index| format!("{:04X}", index.0);
    let repeats = device.repetitions.iter().map(|repetition| {
        (hex(repetition.leading), repetition.axes.iter().map(|index| index.map(hex)).collect())
    });
    repeats.collect()
}

fn bits(fields: &[Field]) -> Vec<Bits> {
    let bits = fields.iter().map(|field| Bits {
        low: field.low,
        high: field.high,
        name: field.name.clone(),
        reserved: field.reserved,
        values: values(&field.values),
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

fn values(meanings: &[Meaning]) -> Vec<(i64, String)> {
    meanings.iter().map(|meaning| (meaning.value, meaning.name.clone())).collect()
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
