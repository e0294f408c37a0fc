//! Units and scaling.

use super::context::Context;
use super::{facts, keys};
use crate::model::{AxisUnit, Path, Scale, Unit};
use crate::raw::{Entity, Fraction, RawPath, RawUnit};

/// The units, in the order in which they were written.
pub(super) fn units(context: &mut Context<'_>, raw: Vec<Entity<RawUnit>>) -> Vec<Unit> {
    raw.into_iter().map(|entity| unit(context, entity)).collect()
}

fn unit(context: &mut Context<'_>, entity: Entity<RawUnit>) -> Unit {
    let axes = axes(context, &entity);
    let Entity { key, origin, raw, facts } = entity;
    Unit {
        id: key,
        quantity: raw.quantity,
        axes,
        factor: raw.factor.and_then(|factor| context.address(&factor, origin.value("factor"))),
        path: raw.path.map(|path| match path {
            RawPath::Pdo => Path::Pdo,
            RawPath::Sdo => Path::Sdo,
        }),
        about: raw.about,
        source: facts::source(context, &facts),
        origin,
    }
}

fn axes(context: &mut Context<'_>, entity: &Entity<RawUnit>) -> Vec<AxisUnit> {
    let raw = &entity.raw;
    let shared = AxisUnit { symbol: raw.symbol.clone(), scale: raw.raw_per_unit.map(lowest) };
    if raw.per_axis.is_empty() {
        return vec![shared];
    }
    let names: Vec<String> = context.axes.iter().map(|axis| axis.name.clone()).collect();
    let mut axes = vec![shared; names.len()];
    for (key, differing) in &raw.per_axis {
        let Some(range) = keys::names(key, &names) else {
            let expected = format!("an axis or a range of axes of {}", names.join(", "));
            context.invalid(key, &expected, entity.origin.value("per-axis"));
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
