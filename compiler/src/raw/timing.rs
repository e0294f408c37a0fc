//! Time: `[sync-modes]`, `[cycle-times]`, `[dead-time]`.

use serde::Deserialize;

use super::Duration;

/// `[sync-modes.<id>]`: a way to keep time with the master.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawSyncMode {
    /// Its name.
    pub name: String,
    /// The value of the register that starts the distributed clocks; 0 for none.
    pub assign_activate: u16,
    /// Whether a master should take it if nothing is said.
    #[serde(default)]
    pub default: bool,
    /// The first signal.
    pub sync0: Option<RawSyncSignal>,
    /// The second signal.
    pub sync1: Option<RawSyncSignal>,
    /// What else is to be said.
    pub about: Option<String>,
}

/// A signal of the distributed clocks.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawSyncSignal {
    /// Its period in cycles of the master.
    pub cycles: Option<i32>,
    /// How much later than the cycle it comes.
    pub shift: Option<Duration>,
}

/// `[cycle-times.<id>]`: how often set values may come.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawCycleTime {
    /// What the limit holds for.
    pub name: String,
    /// The shortest cycle.
    pub min: Option<Duration>,
    /// The cycles that can be chosen, if only some.
    #[serde(default)]
    pub choices: Vec<Duration>,
    /// What else is to be said.
    pub about: Option<String>,
}

/// `[dead-time]`: the time from a set value to its effect.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawDeadTime {
    /// How many cycles of the master it takes.
    pub cycles: u32,
    /// How much time besides.
    pub plus: Duration,
    /// How it comes about.
    pub about: Option<String>,
}
