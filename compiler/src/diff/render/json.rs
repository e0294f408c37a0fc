//! As JSON.

use serde::Serialize;

use super::Places;
use crate::diff::change::{Change, Class};
use crate::diff::changes::Comparison;
use crate::source::Sources;
use crate::text::characters;

/// The version of the format: it grows when a reader of the version before could be misled.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Document<'c> {
    format: &'static str,
    version: u32,
    worst: Option<Class>,
    devices: Vec<Device<'c>>,
    changes: Vec<Shown<'c>>,
}

#[derive(Serialize)]
struct Device<'c> {
    name: &'c str,
    old_revision: Option<u32>,
    new_revision: Option<u32>,
}

#[derive(Serialize)]
struct Shown<'c> {
    kind: &'static str,
    class: Class,
    at: String,
    name: Option<&'c str>,
    old: Option<&'c str>,
    new: Option<&'c str>,
    axes: usize,
    /// By their place in the list of devices.
    devices: &'c [usize],
    old_place: Option<String>,
    new_place: Option<String>,
}

/// A comparison as JSON: `devc-changes`, version 1.
pub fn json(comparison: &Comparison, old: &Sources, new: &Sources) -> String {
    let places = Places { old, new };
    let devices = comparison.devices.iter().map(|device| Device {
        name: &device.name,
        old_revision: device.revisions.map(|(old, _)| old),
        new_revision: device.revisions.map(|(_, new)| new),
    });
    let document = Document {
        format: "devc-changes",
        version: VERSION,
        worst: comparison.worst(),
        devices: devices.collect(),
        changes: comparison.changes.iter().map(|change| shown(change, &places)).collect(),
    };
    // Strings and numbers cannot fail to be written.
    characters::json(&serde_json::to_string_pretty(&document).unwrap_or_default()).into_owned() + "\n"
}

fn shown<'c>(change: &'c Change, places: &Places<'_>) -> Shown<'c> {
    let (old_place, new_place) = places.of(change);
    Shown {
        kind: change.kind.rule.name,
        class: change.kind.class,
        at: change.at.to_string(),
        name: change.name.as_deref(),
        old: change.old.as_deref(),
        new: change.new.as_deref(),
        axes: change.axes,
        devices: &change.devices,
        old_place,
        new_place,
    }
}
