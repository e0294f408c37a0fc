//! The PDOs: one category for each direction.

use super::strings::Strings;
use super::{Category, Extent};
use crate::model::{DataType, Device, Direction, Mapped, Pdo};

/// Stands for the sync manager of a PDO that is not assigned.
const NOT_ASSIGNED: u8 = 0xFF;

/// Flags of a PDO.
const MANDATORY: u16 = 0x01;
const DEFAULT: u16 = 0x02;
const FIXED: u16 = 0x10;

/// Inputs and outputs.
pub(super) fn pdos(device: &Device, extent: Extent, strings: &mut Strings) -> [Option<Category>; 2] {
    [(50, Direction::Tx), (51, Direction::Rx)].map(|(kind, direction)| {
        let pdos = device.pdos_in_order(direction).into_iter();
        let told = pdos.filter(|pdo| extent == Extent::All || device.manager_of(pdo).is_some());
        Category::of(kind, told.flat_map(|it| pdo(device, it, strings)).collect(), 0)
    })
}

/// The PDO with its entries. Its name tells the axis, so that the names of entries serve all axes.
fn pdo(device: &Device, pdo: &Pdo, strings: &mut Strings) -> Vec<u8> {
    let manager = device.manager_of(pdo);
    let flags = [(pdo.mandatory, MANDATORY), (manager.is_some(), DEFAULT), (pdo.fixed, FIXED)];
    let flags = flags.into_iter().filter(|(holds, _)| *holds).fold(0, |flags, (_, flag)| flags | flag);
    let rows: Vec<[u8; 8]> = pdo.entries.iter().flat_map(|mapped| rows(mapped, strings)).collect();
    let count = u8::try_from(rows.len()).unwrap_or(u8::MAX);
    let name = strings.number(&device.on_axis(&pdo.name, pdo.axis));
    let mut data = Vec::from(pdo.index.0.to_le_bytes());
    data.extend([count, manager.map_or(NOT_ASSIGNED, |manager| manager.number), 0, name]);
    data.extend(flags.to_le_bytes());
    data.extend(rows.into_iter().take(count.into()).flatten());
    data
}

/// An entry. One that has more bits than a byte can say goes on as a gap, so that what follows stays in its place.
fn rows(mapped: &Mapped, strings: &mut Strings) -> Vec<[u8; 8]> {
    let mut left = mapped.bits;
    let mut rows = vec![row(mapped, part(&mut left), strings)];
    while left > 0 {
        rows.push([0, 0, 0, 0, 0, part(&mut left), 0, 0]);
    }
    rows
}

fn part(left: &mut u32) -> u8 {
    let bits = u8::try_from(*left).unwrap_or(u8::MAX);
    *left = left.saturating_sub(bits.into());
    bits
}

fn row(mapped: &Mapped, bits: u8, strings: &mut Strings) -> [u8; 8] {
    let Some(address) = mapped.address else { return [0, 0, 0, 0, 0, bits, 0, 0] };
    let [low, high] = address.index.0.to_le_bytes();
    let [data_type, _] = code(mapped).to_le_bytes();
    [low, high, address.subindex, strings.number(&mapped.name), data_type, bits, 0, 0]
}

/// The number of its type; that of a type of the mapped width if it is mapped in another than its own.
fn code(mapped: &Mapped) -> u16 {
    let own = mapped.told_type().filter(|data_type| data_type.bits() == mapped.bits);
    own.or_else(|| DataType::of_width(mapped.bits)).map_or(0, DataType::code)
}
