//! Choices of process data and mode, from which the start-up list follows: `[configurations.<id>]`.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::{RawMapped, raw};
use crate::model::{Duration, Literal};

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
        /// Other values to write.
        #[serde(default)]
        pub writes: Vec<RawWrite>,
        /// What else is to be said.
        pub about: Option<String>,
    }
}

/// A value to write before process data is exchanged: `{ entry = "DRVCFG3", value = 0x10000, why = "..." }`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawWrite {
    /// Where to.
    pub entry: String,
    /// The value.
    pub value: Literal,
    /// The change of the EtherCAT state at which it is written: `"IP"`, `"PS"`, `"SO"`, `"OS"`, `"SP"` or `"OP"`; `"PS"` if
    /// absent. What is written at `"IP"` comes before all else, the rest after it.
    pub transition: Option<String>,
    /// What for.
    pub why: String,
}
