//! Modes of operation: those that the default of 0x6502 announces.

use super::super::toml::{Toml, get};
use super::axes::Axes;
use super::described::Described;
use super::draft::Block;
use super::profile::Known;

/// The supported modes of the first axis.
const SUPPORTED: u16 = 0x6502;

/// `[modes]`, of what all axes have. Modes of a manufacturer's own are known by its manual alone.
pub(super) fn modes(objects: &[Described], axes: &Axes, known: &Known) -> Option<Block> {
    let announced = |index: u16| {
        let object = objects.iter().find(|object| object.index == index)?;
        match get(&object.values.first()?.keys, "default")? {
            Toml::Hex(bits, _) => Some(*bits),
            Toml::Integer(bits) => u64::try_from(*bits).ok(),
            _ => None,
        }
    };
    let bits = axes.indices(SUPPORTED).into_iter().map(|index| announced(index).unwrap_or(0));
    let bits = bits.reduce(|some, others| some & others)?;
    let has = |bit: u8| bits.checked_shr(bit.into()).is_some_and(|rest| rest & 1 == 1);
    let modes = known.modes().iter().filter(|(_, bit)| has(*bit));
    let keys: Vec<_> = modes.map(|(code, _)| (code.to_string(), Toml::Table(Vec::new()))).collect();
    (!keys.is_empty()).then(|| Block::new("modes", None, keys))
}
