//! Process data, as the decoder reads it.

use serde::Serialize;

use super::values;
use crate::model::{self, Address, Device, Index};

#[derive(Debug, Serialize)]
pub(super) struct Pdo {
    index: String,
    name: String,
    bits: u32,
    axis: Option<u8>,
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
    /// The word that it is.
    word: Option<String>,
    values: Vec<(i64, String)>,
}

impl Pdo {
    /// A PDO of a device.
    pub(super) fn of(device: &Device, pdo: &model::Pdo) -> Self {
        Self {
            index: pdo.index.to_string(),
            name: pdo.name.clone(),
            bits: pdo.bits(),
            axis: pdo.axis,
            fields: pdo.entries.iter().map(|one| mapped(device, one)).collect(),
        }
    }
}

fn mapped(device: &Device, mapped: &model::Mapped) -> Mapped {
    let entry = mapped.address.and_then(|address| device.entry(address));
    let object = mapped.address.and_then(|address| device.object(address.index));
    let is_it = |at: Address| {
        Some(at.subindex) == mapped.address.map(|own| own.subindex)
            && Some(at.index) == object.map(|object| object.leading)
    };
    Mapped {
        address: mapped.address.map_or(String::new(), |address| address.to_string()),
        name: mapped.name.clone(),
        offset: mapped.offset,
        bits: mapped.bits,
        data_type: mapped.data_type.map(|data_type| data_type.to_string()),
        unit: entry.and_then(|entry| entry.unit.clone()),
        word: device.words.iter().find(|word| is_it(word.address)).map(|word| word.id.clone()),
        values: match object {
            Some(object) if MODES.contains(&object.leading) => modes(device),
            _ => entry.map_or_else(Vec::new, |entry| values(&entry.values)),
        },
    }
}

/// The objects that hold a mode of operation.
const MODES: [Index; 2] = [Index(0x6060), Index(0x6061)];

fn modes(device: &Device) -> Vec<(i64, String)> {
    device.modes.iter().map(|mode| (mode.code.into(), mode.name.clone())).collect()
}
