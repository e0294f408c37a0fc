//! Units that values are in, by the codes that a file has for them.

use std::collections::BTreeMap;

use super::super::read::{Device, Value};
use super::super::toml::{Keys, Toml, set, set_some};
use super::draft::Block;
use crate::model::UnitCode;
use crate::model::ids::Siblings;

/// The units of a device: the words for them by their codes.
#[derive(Debug, Default)]
pub(super) struct Units(BTreeMap<u32, (&'static UnitCode, i8, String)>);

impl Units {
    pub(super) fn of(device: &Device) -> Self {
        let values = device.objects.iter().flat_map(|object| &object.values);
        let codes: BTreeMap<u32, (&UnitCode, i8)> = values.filter_map(coded).collect();
        let mut ids = Siblings::default();
        let named =
            codes.into_iter().map(|(code, (unit, power))| (code, (unit, power, ids.claim(unit.quantity))));
        Self(named.collect())
    }

    /// The word for the unit of a value.
    pub(super) fn id(&self, value: &Value) -> Option<&str> {
        let (code, _) = coded(value)?;
        self.0.get(&code).map(|(_, _, id)| id.as_str())
    }

    /// `[units]`.
    pub(super) fn blocks(&self) -> impl Iterator<Item = Block> {
        self.0.values().map(|(unit, power, id)| Block::new("units", Some(id.clone()), keys(unit, *power)))
    }
}

fn coded(value: &Value) -> Option<(u32, (&'static UnitCode, i8))> {
    value.unit.map(|(unit, power)| (unit.number(power), (unit, power)))
}

/// A power of ten with a symbol of its own is in that; any other is so many steps to the unit.
fn keys(unit: &UnitCode, power: i8) -> Keys {
    let own = unit.symbol_of(power);
    let mut keys = Keys::new();
    set(&mut keys, "quantity", Toml::text(unit.quantity));
    set(&mut keys, "symbol", Toml::text(own.unwrap_or(unit.symbol)));
    let factor = 10_i128.pow(power.unsigned_abs().into());
    let scale = if power < 0 { Toml::Integer(factor) } else { Toml::text(format!("1/{factor}")) };
    set_some(&mut keys, "raw-per-unit", own.is_none().then_some(scale));
    keys
}
