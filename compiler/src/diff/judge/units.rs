//! Units and scaling.

use super::Presence;
use super::presence;
use crate::diff::change::Kind;
use crate::diff::kinds;
use crate::diff::place::Versions;
use crate::model::{AxisUnit, Device, Difference, Dimension, Entry, Scale, Symbol, Unit};

/// A unit by itself.
pub(super) fn unit(versions: Versions<'_>, path: &[&str], difference: &Difference) -> Option<&'static Kind> {
    let of = |device: &'_ Device, id: &str| device.unit(id).cloned();
    Some(match (path, presence(difference)) {
        // Of a unit that comes or goes the values tell that are in it.
        ([_], Presence::Gone | Presence::Come) => &kinds::CHANGED_TEXT,
        ([id, "axes", ..], _) => changed(of(versions.old, id).as_ref(), of(versions.new, id).as_ref()),
        ([_, "factor"], _) => &kinds::CHANGED_UNIT,
        _ => &kinds::CHANGED_TEXT,
    })
}

/// The unit of a value that is another one.
pub(super) fn of_entry(versions: Versions<'_>, old: &Entry, new: &Entry) -> &'static Kind {
    let of = |device: &Device, entry: &Entry| entry.unit.as_ref().and_then(|id| device.unit(id)).cloned();
    match (of(versions.old, old), of(versions.new, new)) {
        (Some(old), Some(new)) => changed(Some(&old), Some(&new)),
        // What is said for the first time, or no longer, is no other motion for all one knows.
        _ => &kinds::CHANGED_TEXT,
    }
}

fn changed(old: Option<&Unit>, new: Option<&Unit>) -> &'static Kind {
    let Some((old, new)) = old.zip(new) else { return &kinds::CHANGED_UNIT };
    let axes = u8::try_from(old.axes.len().max(new.axes.len())).unwrap_or(u8::MAX);
    let is_same = |axis| match (old.on(Some(axis)), new.on(Some(axis))) {
        (Some(old), Some(new)) => means(old) == means(new),
        (old, new) => old == new,
    };
    if (0..axes).all(is_same) { &kinds::RESPELT_UNIT } else { &kinds::CHANGED_UNIT }
}

/// What a step is: so many of the smallest unit of a dimension, or of the device's own.
fn means(unit: &AxisUnit) -> (Option<Dimension>, Option<Scale>, Option<&str>) {
    let scale = unit.scale.unwrap_or(Scale { raw: 1, units: 1 });
    match Symbol::find(&unit.symbol) {
        Some(symbol) => {
            let smallest =
                scale.units.checked_mul(symbol.smallest).map(|units| Scale::lowest(scale.raw, units));
            (Some(symbol.dimension), smallest, None)
        }
        None => (None, Some(scale), Some(&unit.symbol)),
    }
}
