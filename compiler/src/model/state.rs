//! State machines.

use super::table::{part, table};
use super::{OneOrMore, Pattern};

table! {
    /// `[states.<id>]`: a state of the drive.
    pub struct State by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// The bits of the statusword that show it, highest first: `"x01x 0001"`; `x` is either.
        pub pattern: Option<Pattern>,
        /// What it means.
        pub about: Option<String>,
        /// Whether the brake is applied.
        pub brake: Option<Answer>,
        /// Whether the control electronics have power.
        pub low_level_power: Option<Answer>,
        /// Whether the power stage has power.
        pub high_level_power: Option<Answer>,
        /// Whether the drive acts on its set values.
        pub drive_function: Option<Answer>,
        /// Whether parameters may be changed.
        pub configuration: Option<Answer>,
        /// What holds in it, a sentence each.
        #[serde(default)]
        pub features: Vec<String>,
        /// What can bring the drive into it, a sentence each.
        #[serde(default)]
        pub causes: Vec<String>,
    }

    /// `[commands.<id>]`: what a pattern of the controlword asks for.
    pub struct Command by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// The bits of the controlword, highest first: `"rxxx xxxx"`; `x` is either, `r` a rising edge, `f` a
        /// falling one.
        pub pattern: Option<Pattern>,
        /// The transitions that it sets off, by number.
        #[serde(default)]
        pub transitions: Vec<u8>,
        /// What it does.
        pub about: Option<String>,
        /// The states in which it is ignored, by id.
        #[serde(default)]
        pub ignored_in: Vec<String>,
    }

    /// `[transitions.<number>]`: a change of state.
    pub struct Transition by number: "the number of a transition" {
        /// Its number.
        #[serde(skip_deserializing)]
        pub number: u8,
        /// The state before, or a list of several, by id; absent for the start, or if it can come from any.
        #[serde(default)]
        pub from: OneOrMore,
        /// The state after, by id.
        pub to: String,
        /// Whether it happens without a command.
        #[serde(default)]
        pub automatic: bool,
        /// Whether the device makes it at all; true if absent.
        #[serde(default = "super::yes")]
        pub supported: bool,
        /// The bits of the controlword that set it off, where the manual gives them for a transition.
        pub pattern: Option<Pattern>,
        /// What such bits are called as a command, as `"Shutdown"`.
        pub command: Option<String>,
        /// What sets it off without a command, any of them.
        #[serde(default)]
        pub events: Vec<Event>,
        /// What keeps a command from setting it off while it holds, any of them.
        #[serde(default)]
        pub interlocks: Vec<Event>,
        /// Whether all axes must make it, or one is enough, to move the whole device.
        pub axes: Option<Scope>,
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

    /// `[communication-states.<id>]`: a state of the EtherCAT state machine.
    pub struct CommunicationState by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// Its number in AL control and AL status.
        pub code: u8,
        /// What the device does in it.
        pub about: Option<String>,
    }

    /// `[communication-transitions.<id>]`: a change of the EtherCAT state, named by two letters such as `PS`.
    pub struct CommunicationTransition by id: "two letters such as PS" {
        /// Its two letters, such as `PS`.
        #[serde(skip_deserializing)]
        pub id: String,
        /// The state before, by id.
        pub from: String,
        /// The state after, by id.
        pub to: String,
        /// What the device does.
        pub about: Option<String>,
    }
}

part! {
    /// Yes, no, or on a condition.
    #[derive(Copy, Eq)]
    pub enum Answer {
        /// Yes.
        Yes,
        /// No.
        No,
        /// If the drive function needs it.
        IfRequired,
    }

    /// What happens in a drive besides its commands, the most urgent first.
    #[derive(Copy, Eq, PartialOrd, Ord)]
    pub enum Event {
        /// The cause of a fault is there.
        Fault,
        /// The reaction to a fault is over.
        FaultReactionOver,
        /// Start-up and self-test are over.
        Initialised,
        /// Something outside forbids power: no supply, safe torque off.
        LockedOut,
        /// An additional enable signal is missing.
        NotEnabled,
        /// The quick stop is over, and the drive does not stay in its state.
        QuickStopOver,
    }

    /// How many axes must make a transition.
    #[derive(Copy, Eq)]
    pub enum Scope {
        /// Every one.
        All,
        /// One or more.
        Any,
    }
}

impl State {
    /// The ids of the states of CiA 402.
    pub const OF_PROFILE: &[&str] = &[
        "not-ready-to-switch-on",
        "switch-on-disabled",
        "ready-to-switch-on",
        "switched-on",
        "operation-enabled",
        "quick-stop-active",
        "fault-reaction-active",
        "fault",
    ];

    /// Whether it is one of the states of CiA 402.
    pub fn is_of_profile(&self) -> bool {
        Self::OF_PROFILE.contains(&self.id.as_str())
    }
}

impl Event {
    /// Its name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fault => "fault",
            Self::FaultReactionOver => "fault reaction over",
            Self::Initialised => "initialised",
            Self::LockedOut => "locked out",
            Self::NotEnabled => "not enabled",
            Self::QuickStopOver => "quick stop over",
        }
    }
}
