//! Whether the revision number says what has changed.

use super::change::{Change, Class};
use super::changes::{Comparison, Versioned};
use super::kinds;

/// What the gate says of a device.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Gate {
    /// Nothing has changed that a revision number has to announce, or it does.
    Passed,
    /// Something breaks what was made for the old version, and the revision number is not higher.
    MustRise {
        /// The device.
        device: String,
        /// The revision number of both versions.
        revision: u32,
        /// How bad it is.
        class: Class,
    },
    /// The revision number is lower.
    Lowered {
        /// The device.
        device: String,
        /// The old revision number.
        old: u32,
        /// The new one.
        new: u32,
    },
}

/// What the gate says of each device.
pub fn gate(comparison: &Comparison) -> Vec<Gate> {
    let devices = comparison.devices.iter().enumerate();
    devices.map(|(number, device)| of_device(device, &comparison.of(number).collect::<Vec<_>>())).collect()
}

fn of_device(device: &Versioned, changes: &[&Change]) -> Gate {
    let Some((old, new)) = device.revisions else { return Gate::Passed };
    let worst = changes.iter().map(|change| change.kind.class).max();
    let is_another = changes.iter().any(|change| *change.kind == kinds::CHANGED_DEVICE);
    match worst {
        // Another device has revisions of its own.
        _ if is_another => Gate::Passed,
        _ if new < old => Gate::Lowered { device: device.name.clone(), old, new },
        Some(class) if class >= Class::ConfigurationBreaking && new == old => {
            Gate::MustRise { device: device.name.clone(), revision: new, class }
        }
        _ => Gate::Passed,
    }
}

impl Gate {
    /// What is wrong, and what to do about it; nothing if it is passed.
    pub fn complaint(&self) -> Option<(String, String)> {
        match self {
            Self::Passed => None,
            Self::MustRise { device, revision, class } => Some((
                format!("`{device}` has {} changes, and its revision number is still 0x{revision:08X}", class.name()),
                "raise `revision` in `[identity]`, or take the changes back".to_owned(),
            )),
            Self::Lowered { device, old, new } => Some((
                format!("the revision number of `{device}` falls from 0x{old:08X} to 0x{new:08X}"),
                "give the new version a higher `revision` in `[identity]`; if the versions were swapped, swap them".to_owned(),
            )),
        }
    }
}
