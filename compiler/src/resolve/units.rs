//! Units and scaling.

use super::context::Context;
use crate::model::{AxisUnit, Fraction, Scale, Unit};
use crate::raw::RawUnit;
use crate::source::keys;

/// The units, in the order in which they were written.
pub(super) fn units(context: &mut Context<'_>, raw: Vec<RawUnit>) -> Vec<Unit> {
    raw.into_iter().map(|raw| unit(context, raw)).collect()
}

fn unit(context: &mut Context<'_>, raw: RawUnit) -> Unit {
    let axes = axes(context, &raw);
    let RawUnit {
        key: id,
        quantity,
        symbol: _,
        raw_per_unit: _,
        factor,
        path,
        per_axis: _,
        about,
        source,
        origin,
    } = raw;
    let factor = factor.and_then(|factor| context.address(&factor, origin.value("factor")));
    Unit { id, quantity, axes, factor, path, about, source, origin }
}

fn axes(context: &mut Context<'_>, raw: &RawUnit) -> Vec<AxisUnit> {
    let shared = AxisUnit { symbol: raw.symbol.clone(), scale: raw.raw_per_unit.map(lowest) };
    if raw.per_axis.is_empty() {
        return vec![shared];
    }
    let names: Vec<String> = context.axes.iter().map(|axis| axis.name.clone()).collect();
    let mut axes = vec![shared; names.len()];
    for (key, differing) in &raw.per_axis {
        let Some(range) = keys::names(key, &names) else {
            let expected = format!("an axis or a range of axes of {}", keys::some(&names));
            context.invalid(key, &expected, raw.origin.key(&format!("per-axis.{key}")));
            continue;
        };
        for axis in axes.get_mut(range).into_iter().flatten() {
            axis.symbol = differing.symbol.clone().unwrap_or_else(|| axis.symbol.clone());
            axis.scale = differing.raw_per_unit.map(lowest).or(axis.scale);
        }
    }
    axes
}

fn lowest(fraction: Fraction) -> Scale {
    Scale::lowest(fraction.numerator, fraction.denominator)
}
