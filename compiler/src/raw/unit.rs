//! Units and scaling: `[units.<id>]`.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::raw;
use crate::model::{Fraction, Path};

raw! {
    /// `[units.<id>]`: what a raw number means.
    pub struct RawUnit {
        /// The physical quantity, such as `position`.
        pub quantity: String,
        /// The unit of the scaled value, such as `mm`: a [symbol](#symbols), or a word of the device's own.
        pub symbol: String,
        /// How many raw steps make one unit: a whole number, or a fraction `"4294967296/30720000"`.
        pub raw_per_unit: Option<Fraction>,
        /// The object that holds the scaling.
        pub factor: Option<String>,
        /// How the values travel: `"pdo"`, `"sdo"`; both if absent.
        pub path: Option<Path>,
        /// Axes with another unit, by name or range of names.
        #[serde(default)]
        pub per_axis: BTreeMap<String, RawAxisUnit>,
        /// What else is to be said.
        pub about: Option<String>,
    }
}

/// What differs on an axis.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawAxisUnit {
    /// The unit of the scaled value.
    pub symbol: Option<String>,
    /// How many raw steps make one unit.
    pub raw_per_unit: Option<Fraction>,
}
