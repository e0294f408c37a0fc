//! Axes: `[axes]`.

use serde::Deserialize;

use super::raw;
use crate::model::Index;
use crate::source::keys;

raw! {
    /// `[axes]`: the axes of a device and how their objects are spaced.
    pub struct RawAxes {
        /// The names, in order.
        pub names: Vec<String>,
        /// What each axis does, in the order of the names.
        #[serde(default)]
        pub about: Vec<String>,
        /// Which objects exist once for each axis, and how far apart they are.
        #[serde(default)]
        pub shifts: Vec<RawShift>,
        /// How far apart the PDOs of the axes are.
        pub pdo_shift: Option<u16>,
        /// What each axis is, as the upper half of the device type 0x1000 says it of a device with one axis: 1 a
        /// frequency converter, 2 a servo drive, 4 a stepper motor (CiA 402).
        pub add_info: Option<u16>,
        /// How the axes depend on each other.
        pub coupling: Option<String>,
    }
}

/// A range of indices that exists once for each axis.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawShift {
    /// The indices of the first axis, as `"0x6000..=0x67FF"`.
    pub range: String,
    /// The distance from an axis to the next.
    pub by: u16,
}

impl RawAxes {
    /// The index on the first axis of what lies at an index on another one, and that axis.
    pub(super) fn leading(&self, index: Index) -> Option<(Index, Option<usize>)> {
        self.shifts.iter().find_map(|shift| {
            let range = keys::range::<u16>(&shift.range)?;
            let mut axes = (1..self.names.len()).filter_map(|axis| {
                let distance = u16::try_from(axis).ok()?.checked_mul(shift.by)?;
                let leading = index.0.checked_sub(distance).filter(|leading| range.contains(leading))?;
                Some((Index(leading), Some(axis)))
            });
            axes.next()
        })
    }

    /// Whether an axis is one of those that a name or a range of names means.
    pub(super) fn has(&self, names: &str, axis: usize) -> bool {
        keys::names(names, &self.names).is_some_and(|range| range.contains(&axis))
    }
}
