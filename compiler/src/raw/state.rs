//! The drive state machine: `[states]`, `[commands]`, `[transitions]`, and the EtherCAT one.

use serde::Deserialize;

use super::OneOrMore;

/// `[states.<id>]`: a state of the drive.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawState {
    /// Its name.
    pub name: String,
    /// The bits of the statusword that show it, highest first: `"x01x 0001"`; `x` is either.
    pub pattern: Option<String>,
    /// What it means.
    pub about: Option<String>,
    /// Whether the brake is applied.
    pub brake: Option<RawAnswer>,
    /// Whether the control electronics have power.
    pub low_level_power: Option<RawAnswer>,
    /// Whether the power stage has power.
    pub high_level_power: Option<RawAnswer>,
    /// Whether the drive acts on its set values.
    pub drive_function: Option<RawAnswer>,
    /// Whether parameters may be changed.
    pub configuration: Option<RawAnswer>,
    /// What holds in it, a sentence each.
    #[serde(default)]
    pub features: Vec<String>,
    /// What can bring the drive into it, a sentence each.
    #[serde(default)]
    pub causes: Vec<String>,
}

/// Yes, no, or on a condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawAnswer {
    /// Yes.
    Yes,
    /// No.
    No,
    /// If the drive function needs it.
    IfRequired,
}

/// `[commands.<id>]`: what a pattern of the controlword asks for.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawCommand {
    /// Its name.
    pub name: String,
    /// The bits of the controlword, highest first: `"rxxx xxxx"`; `x` is either, `r` a rising edge, `f` a
    /// falling one.
    pub pattern: Option<String>,
    /// The transitions that it sets off, by number.
    #[serde(default)]
    pub transitions: Vec<u8>,
    /// What it does.
    pub about: Option<String>,
    /// The states in which it is ignored.
    #[serde(default)]
    pub ignored_in: Vec<String>,
}

/// `[transitions.<number>]`: a change of state.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawTransition {
    /// The state before, or a list of several; absent for the start, or if it can come from any.
    #[serde(default)]
    pub from: OneOrMore,
    /// The state after.
    pub to: String,
    /// Whether it happens without a command.
    #[serde(default)]
    pub automatic: bool,
    /// Whether the device makes it at all; true if absent.
    pub supported: Option<bool>,
    /// The bits of the controlword that set it off, where the manual gives them for a transition.
    pub pattern: Option<String>,
    /// What such bits are called as a command, as `"Shutdown"`.
    pub command: Option<String>,
    /// What sets it off without a command, any of them.
    #[serde(default)]
    pub events: Vec<RawEvent>,
    /// What keeps a command from setting it off while it holds, any of them.
    #[serde(default)]
    pub interlocks: Vec<RawEvent>,
    /// Whether all axes must make it, or one is enough, to move the whole device.
    pub axes: Option<RawScope>,
    /// The power level that it switches to.
    pub power: Option<String>,
    /// What it waits for, a sentence each, all of them.
    #[serde(default)]
    pub conditions: Vec<String>,
    /// What else sets it off, a sentence each, any of them.
    #[serde(default)]
    pub causes: Vec<String>,
    /// What it does.
    pub about: Option<String>,
}

/// What happens in a drive besides its commands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawEvent {
    /// Start-up and self-test are over.
    Initialised,
    /// The cause of a fault is there.
    Fault,
    /// The reaction to a fault is over.
    FaultReactionOver,
    /// The quick stop is over, and the drive does not stay in its state.
    QuickStopOver,
    /// Something outside forbids power: no supply, safe torque off.
    LockedOut,
    /// An additional enable signal is missing.
    NotEnabled,
}

/// How many axes must make a transition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawScope {
    /// Every one.
    All,
    /// One or more.
    Any,
}

/// `[communication-states.<id>]`: a state of the EtherCAT state machine.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawCommunicationState {
    /// Its name.
    pub name: String,
    /// Its number in AL control and AL status.
    pub code: u8,
    /// What the device does in it.
    pub about: Option<String>,
}

/// `[communication-transitions.<id>]`: a change of the EtherCAT state, named by two letters such as `PS`.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawCommunicationTransition {
    /// The state before.
    pub from: String,
    /// The state after.
    pub to: String,
    /// What the device does.
    pub about: Option<String>,
}
