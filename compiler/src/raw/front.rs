//! What a person sees and does: `[leds]`, `[connectors]`, `[[master-settings]]`, `[procedures]`, `[limits]`.

use serde::Deserialize;

use super::Literal;

/// `[leds.<id>]`: a light.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawLed {
    /// What is printed beside it.
    pub name: String,
    /// Its colour.
    pub colour: Option<String>,
    /// What it shows.
    pub about: Option<String>,
    /// What its patterns mean.
    #[serde(default)]
    pub patterns: Vec<RawLedPattern>,
}

/// What a light does, and what it means by that.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawLedPattern {
    /// What it does: `off`, `on`, `blinking`, `single flash` ...
    pub shows: String,
    /// What that means.
    pub means: String,
}

/// `[connectors.<id>]`: a socket.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawConnector {
    /// What is printed beside it.
    pub name: String,
    /// Its kind.
    pub kind: Option<String>,
    /// What goes in.
    pub about: Option<String>,
}

/// `[[master-settings]]`: something to be set in the master.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawMasterSetting {
    /// What.
    pub name: String,
    /// To which value.
    pub value: String,
    /// Whether once for each axis.
    #[serde(default)]
    pub per_axis: bool,
    /// Why.
    pub about: Option<String>,
}

/// `[procedures.<id>]`: things to do in order.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawProcedure {
    /// What it achieves.
    pub name: String,
    /// What there is to know first.
    pub about: Option<String>,
    /// The steps.
    pub steps: Vec<RawStep>,
}

/// A step of a procedure.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawStep {
    /// What to do.
    pub r#do: String,
    /// The object that it is done with.
    pub object: Option<String>,
    /// The value to write.
    pub write: Option<Literal>,
}

/// `[limits.<id>]`: a figure that the device keeps to or asks for.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawLimit {
    /// What is limited.
    pub name: String,
    /// The figure with its unit.
    pub value: String,
    /// What happens beyond it.
    pub about: Option<String>,
}
