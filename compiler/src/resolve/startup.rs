//! The writes through the mailbox that bring a configuration about.
//!
//! The order is the one that ETG.1020 asks for: assignments are cleared before mappings change, and a count
//! is written after what it counts. What the mailbox does not let a master write is not in it.

use super::context::Context;
use super::objects;
use crate::model::{Address, Configuration, Direction, Index, Mailbox, Mapped, Object, Pdo, SdoWrite};

const OUTPUTS: Index = Index(0x1C12);
const INPUTS: Index = Index(0x1C13);

/// The start-up list of a configuration, in order.
pub(super) fn startup(
    context: &Context<'_>,
    configuration: &Configuration,
    objects: &[Object],
    mailbox: Option<&Mailbox>,
) -> Vec<SdoWrite> {
    let assigns = mailbox.is_none_or(|mailbox| mailbox.pdo_assign);
    let maps = mailbox.is_none_or(|mailbox| mailbox.pdo_config);
    let assignments = [(OUTPUTS, &configuration.outputs), (INPUTS, &configuration.inputs)];
    let chosen = || {
        let chosen = assignments.iter().filter(|_| assigns);
        chosen.filter_map(|(index, pdos)| pdos.as_ref().map(|pdos| (*index, pdos)))
    };
    let mut writes: Vec<SdoWrite> =
        chosen().map(|(index, _)| count(index, 0, format!("clear the assignment {index}"))).collect();
    if maps {
        writes.extend(of(configuration, Direction::Tx).flat_map(mapping));
        writes.extend(of(configuration, Direction::Rx).flat_map(mapping));
    }
    writes.extend(chosen().flat_map(|(index, pdos)| assignment(index, pdos)));
    for axis in &context.axes {
        writes.extend(mode(configuration, on_axis(context, objects, "0x6060", axis.number)));
        writes.extend(cycle(configuration, on_axis(context, objects, "0x60C2", axis.number)));
    }
    writes
}

/// Where an object lies on an axis, if it does anything there.
fn on_axis(context: &Context<'_>, objects: &[Object], text: &str, axis: u8) -> Option<Index> {
    let address = context.names.find(text)?;
    let index = context.on_axis(address, Some(axis)).index;
    objects::at(objects, index).filter(|object| object.functional).map(|object| object.index)
}

fn of(configuration: &Configuration, direction: Direction) -> impl Iterator<Item = &Pdo> {
    configuration.mapping.iter().filter(move |pdo| pdo.direction == direction)
}

fn write(index: Index, subindex: u8, data: Vec<u8>, comment: String) -> SdoWrite {
    let address = Address { index, subindex };
    SdoWrite { transition: "PS".to_owned(), address, data, comment }
}

fn count(index: Index, count: u8, comment: String) -> SdoWrite {
    write(index, 0, vec![count], comment)
}

fn mapping(pdo: &Pdo) -> Vec<SdoWrite> {
    let mut writes = vec![count(pdo.index, 0, format!("clear the mapping of {}", pdo.index))];
    let numbered = (1..=u8::MAX).zip(&pdo.entries);
    writes.extend(numbered.map(|(subindex, entry)| {
        write(pdo.index, subindex, word(entry).to_le_bytes().to_vec(), format!("map {}", entry.name))
    }));
    let used = u8::try_from(pdo.entries.len()).unwrap_or(u8::MAX);
    writes.push(count(pdo.index, used, format!("number of entries of {}", pdo.index)));
    writes
}

/// What a mapping object holds for an entry: index, subindex, width.
pub(super) fn word(entry: &Mapped) -> u32 {
    let place = entry
        .address
        .map_or(0, |Address { index, subindex }| u32::from(index.0) << 16 | u32::from(subindex) << 8);
    place | (entry.bits & 0xFF)
}

fn assignment(index: Index, pdos: &[Index]) -> Vec<SdoWrite> {
    let numbered = (1..=u8::MAX).zip(pdos);
    let mut writes: Vec<SdoWrite> = numbered
        .map(|(subindex, pdo)| write(index, subindex, pdo.0.to_le_bytes().to_vec(), format!("assign {pdo}")))
        .collect();
    let used = u8::try_from(pdos.len()).unwrap_or(u8::MAX);
    writes.push(count(index, used, format!("number of PDOs in {index}")));
    writes
}

fn mode(configuration: &Configuration, index: Option<Index>) -> Option<SdoWrite> {
    let mode = i8::try_from(configuration.mode?).ok()?;
    Some(write(index?, 0, mode.to_le_bytes().to_vec(), "mode of operation".to_owned()))
}

/// 0x60C2 counts in powers of ten of a second: the largest unit in which the time is a whole number.
fn cycle(configuration: &Configuration, index: Option<Index>) -> Vec<SdoWrite> {
    let (Some(ns), Some(index)) = (configuration.cycle_time.map(|time| time.0).filter(|ns| *ns > 0), index)
    else {
        return Vec::new();
    };
    let mut count = ns;
    let mut exponent = -9_i8;
    while count.is_multiple_of(10) && exponent < -3 {
        count /= 10;
        exponent += 1;
    }
    let Ok(count) = u8::try_from(count) else { return Vec::new() };
    vec![
        write(index, 1, vec![count], "interpolation time period".to_owned()),
        write(index, 2, exponent.to_le_bytes().to_vec(), "its power of ten in seconds".to_owned()),
    ]
}
