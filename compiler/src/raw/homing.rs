//! Homing methods: `[homing-methods.<number>]`.

use serde::Deserialize;

/// `[homing-methods.<number>]`: a way to find the reference position, by its number in 0x6098.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawHomingMethod {
    /// Its name.
    pub name: String,
    /// The vendor's own name for it.
    pub method: Option<String>,
    /// Other numbers that select it.
    #[serde(default)]
    pub aliases: Vec<i8>,
    /// The direction in which it starts; none if it does not move.
    pub direction: Option<RawDirection>,
    /// Whether it ends on an index pulse.
    #[serde(default)]
    pub pulse: bool,
    /// What it looks for besides.
    pub target: Option<String>,
    /// The parameters that it uses.
    #[serde(default)]
    pub parameters: Vec<String>,
    /// What the drive does, step by step.
    #[serde(default)]
    pub steps: Vec<String>,
    /// What it does instead where that depends on where it starts.
    #[serde(default)]
    pub alternatives: Vec<RawAlternative>,
    /// What else is to be said.
    pub about: Option<String>,
}

/// A direction of movement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawDirection {
    /// Towards greater positions.
    Positive,
    /// Towards smaller positions.
    Negative,
}

/// What happens in one of several cases.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawAlternative {
    /// The case.
    pub when: String,
    /// What the drive does, step by step.
    pub steps: Vec<String>,
}
