//! Modes of operation, the changes between them, and how the drive stops.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::RawField;

/// `[modes.<code>]`: a mode of operation by its code in 0x6060.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawMode {
    /// The word for it, such as `csp`.
    pub id: String,
    /// Its name.
    pub name: String,
    /// What the drive does in it.
    pub about: Option<String>,
    /// Other codes that select it.
    #[serde(default)]
    pub aliases: Vec<i16>,
    /// Whether the master sends a new set value every cycle.
    #[serde(default)]
    pub cyclic: bool,
    /// The bit of 0x6502 that announces it; none for modes that it does not list.
    pub supported_bit: Option<u8>,
    /// The objects that it uses.
    #[serde(default)]
    pub objects: Vec<String>,
    /// What it makes of bits of the controlword.
    #[serde(default)]
    pub control_bits: BTreeMap<String, RawField>,
    /// What it makes of bits of the statusword.
    #[serde(default)]
    pub status_bits: BTreeMap<String, RawField>,
    /// Which bits a reference run is started and followed by.
    pub homing_bits: Option<RawHomingBits>,
    /// What must be so before it is chosen, a sentence each.
    #[serde(default)]
    pub conditions: Vec<String>,
    /// What a user should know, a sentence each; what can do damage first.
    #[serde(default)]
    pub cautions: Vec<String>,
    /// The motion commands that the drive runs for it.
    #[serde(default)]
    pub commands: Vec<RawMotionCommand>,
}

/// The bits of a reference run, by number.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawHomingBits {
    /// Of the controlword: its rising edge starts the run.
    pub start: u8,
    /// Of the statusword: the axis has come to where it should, or stands.
    pub reached: u8,
    /// Of the statusword: the reference is set.
    pub attained: u8,
    /// Of the statusword: the run has failed.
    pub error: u8,
}

/// A command of the motion core that a mode runs.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawMotionCommand {
    /// Its number.
    pub code: Option<u16>,
    /// Its name.
    pub name: String,
    /// The setting that chooses it within the mode.
    pub when: Option<String>,
    /// What it does.
    pub about: Option<String>,
    /// What is controlled.
    pub control: Option<String>,
    /// The motion variables it needs.
    #[serde(default)]
    pub variables: Vec<String>,
}

/// `[[mode-changes]]`: a change of mode that the device knows.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawModeChange {
    /// The modes before; any if absent.
    #[serde(default)]
    pub from: Vec<i16>,
    /// The modes after; any if absent.
    #[serde(default)]
    pub to: Vec<i16>,
    /// When it has worked.
    pub done_when: Option<String>,
    /// When it ends in a fault.
    pub fault_when: Option<String>,
    /// What else is to be said.
    pub about: Option<String>,
}

/// `[[stop-options]]`: what stops the drive, and how.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawStopOption {
    /// What happens to the drive.
    pub action: String,
    /// The transitions it goes through.
    #[serde(default)]
    pub transitions: Vec<u8>,
    /// What the drive does.
    pub reaction: String,
    /// How it slows down.
    pub ramp: Option<String>,
    /// What else is to be said.
    pub about: Option<String>,
}
