//! What the device does with what it is asked for at the wrong time: `[device-control]`.

use serde::Deserialize;

/// `[device-control]`: what the device does with what it is asked for at the wrong time.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawDeviceControl {
    /// What it does with a command that leads nowhere in the present state, and with bits that make no command;
    /// it ignores them if absent.
    pub wrong_command: Option<RawRefusal>,
    /// What it does with a mode of operation that it does not have or does not change to; it ignores the change
    /// if absent.
    pub wrong_mode: Option<RawRefusal>,
    /// The states in which a mode of operation can be selected; every one if absent.
    #[serde(default)]
    pub modes_selectable_in: Vec<String>,
    /// What else is to be said.
    pub about: Option<String>,
}

/// What the device does with what is not allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawRefusal {
    /// Nothing.
    Ignored,
    /// It takes it for a fault, and makes transition 13.
    Fault,
}
