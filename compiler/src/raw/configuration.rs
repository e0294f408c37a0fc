//! Choices of process data and mode, from which the start-up list follows: `[configurations.<id>]`.

use std::collections::BTreeMap;

use super::{RawMapped, raw};
use crate::model::Duration;

raw! {
    /// `[configurations.<id>]`: what a master chooses before it goes to Safe-Operational.
    pub struct RawConfiguration {
        /// What it is good for.
        pub name: String,
        /// Whether a master takes it if nothing else is chosen: the ESI has its start-up list.
        #[serde(default)]
        pub default: bool,
        /// The PDOs to assign to the outputs; untouched if absent. That of the first axis stands for all axes.
        pub outputs: Option<Vec<String>>,
        /// The PDOs to assign to the inputs; untouched if absent. That of the first axis stands for all axes.
        pub inputs: Option<Vec<String>>,
        /// What to map, by PDO; for PDOs whose mapping is free.
        #[serde(default)]
        pub mapping: BTreeMap<String, Vec<RawMapped>>,
        /// The mode of operation to write to 0x6060.
        pub mode: Option<i16>,
        /// The cycle time to write to 0x60C2.
        pub cycle_time: Option<Duration>,
        /// What else is to be said.
        pub about: Option<String>,
    }
}
