//! Axes: `[axes]`.

use serde::Deserialize;

use super::raw;

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
