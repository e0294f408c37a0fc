//! The writes through the mailbox that bring a configuration about.
//!
//! The order is the one that ETG.1020 asks for: assignments are cleared before mappings change, and a count
//! is written after what it counts.

use super::context::Context;
use crate::model::{Address, Configuration, Direction, Index, Mapped, Pdo, SdoWrite};

const OUTPUTS: Index = Index(0x1C12);
const INPUTS: Index = Index(0x1C13);

/// The start-up list of a configuration, in order.
pub(super) fn startup(context: &Context<'_>, configuration: &Configuration) -> Vec<SdoWrite> {
    let assignments = [(OUTPUTS, &configuration.outputs), (INPUTS, &configuration.inputs)];
    let chosen = || assignments.iter().filter_map(|(index, pdos)| pdos.as_ref().map(|pdos| (*index, pdos)));
    let mut writes: Vec<SdoWrite> =
        chosen().map(|(index, _)| count(index, 0, format!("clear the assignment {index}"))).collect();
    writes.extend(of(configuration, Direction::Tx).flat_map(mapping));
    writes.extend(of(configuration, Direction::Rx).flat_map(mapping));
    writes.extend(chosen().flat_map(|(index, pdos)| assignment(index, pdos)));
    writes.extend(mode(context, configuration));
    writes.extend(cycle(context, configuration));
    writes
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

fn mode(context: &Context<'_>, configuration: &Configuration) -> Option<SdoWrite> {
    let mode = i8::try_from(configuration.mode?).ok()?;
    let address = context.names.find("0x6060").ok()?;
    Some(write(address.index, 0, mode.to_le_bytes().to_vec(), "mode of operation".to_owned()))
}

/// 0x60C2 counts in powers of ten of a second: the largest unit in which the time is a whole number.
fn cycle(context: &Context<'_>, configuration: &Configuration) -> Vec<SdoWrite> {
    let Some(ns) = configuration.cycle_ns.filter(|ns| *ns > 0) else { return Vec::new() };
    let Ok(address) = context.names.find("0x60C2") else { return Vec::new() };
    let mut count = ns;
    let mut exponent = -9_i8;
    while count.is_multiple_of(10) && exponent < -3 {
        count /= 10;
        exponent += 1;
    }
    let Ok(count) = u8::try_from(count) else { return Vec::new() };
    let index = address.index;
    vec![
        write(index, 1, vec![count], "interpolation time period".to_owned()),
        write(index, 2, exponent.to_le_bytes().to_vec(), "its power of ten in seconds".to_owned()),
    ]
}
