//! What a step of a raw value is, in a few ASCII words where the symbol allows it.

use crate::model::Unit;

/// The unit of a raw value on an axis, `1/1000 mm` or `mm`; none where the raw value is all that is known.
pub(super) fn on(unit: &Unit, axis: Option<u8>) -> Option<String> {
    let of_axis = unit.on(axis)?;
    Some(match of_axis.scale.filter(|scale| scale.raw != scale.units) {
        Some(scale) => format!("{}/{} {}", scale.units, scale.raw, of_axis.symbol),
        None => of_axis.symbol.clone(),
    })
}
