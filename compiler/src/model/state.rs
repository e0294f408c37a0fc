//! State machines.

use super::{Pattern, Source, model};
use crate::source::Origin;

model! {
    /// A state of the drive.
    pub struct State {
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The bits of the statusword that show it.
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
        /// What holds in it.
        pub features: Vec<String>,
        /// What can bring the drive into it.
        pub causes: Vec<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// Yes, no, or on a condition.
    #[derive(Copy, Eq)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum Answer {
        /// Yes.
        Yes,
        /// No.
        No,
        /// If the drive function needs it.
        IfRequired,
    }

    /// What a pattern of the controlword asks for.
    pub struct Command {
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The bits of the controlword.
        pub pattern: Option<Pattern>,
        /// The transitions that it sets off.
        pub transitions: Vec<u8>,
        /// What it does.
        pub about: Option<String>,
        /// The states in which it is ignored, by id.
        pub ignored_in: Vec<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// A change of state.
    pub struct Transition {
        /// Its number.
        pub number: u8,
        /// The states before, by id; none for the start, or if it can come from any.
        pub from: Vec<String>,
        /// The state after, by id.
        pub to: String,
        /// Whether it happens without a command.
        pub automatic: bool,
        /// Whether the device makes it at all.
        pub supported: bool,
        /// The bits of the controlword that set it off, where given for the transition itself.
        pub pattern: Option<Pattern>,
        /// What these bits are called as a command.
        pub command: Option<String>,
        /// What sets it off without a command, any of them.
        pub events: Vec<Event>,
        /// What keeps a command from setting it off, any of them.
        pub interlocks: Vec<Event>,
        /// How many axes must make it to move the whole device.
        pub axes: Option<Scope>,
        /// The power level that it switches to.
        pub power: Option<String>,
        /// What it waits for, all of them.
        pub conditions: Vec<String>,
        /// What else sets it off, any of them.
        pub causes: Vec<String>,
        /// What it does.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// What happens in a drive besides its commands, the most urgent first.
    #[derive(Copy, Eq, PartialOrd, Ord)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum Event {
        /// The cause of a fault is there.
        Fault,
        /// The reaction to a fault is over.
        FaultReactionOver,
        /// Start-up and self-test are over.
        Initialised,
        /// Something outside forbids power.
        LockedOut,
        /// An additional enable signal is missing.
        NotEnabled,
        /// The quick stop is over, and the drive does not stay in its state.
        QuickStopOver,
    }

    /// How many axes must make a transition.
    #[derive(Copy, Eq)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum Scope {
        /// Every one.
        All,
        /// One or more.
        Any,
    }

    /// A state of the EtherCAT state machine.
    pub struct CommunicationState {
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// Its number in AL control and AL status.
        pub code: u8,
        /// What the device does in it.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
    }

    /// A change of the EtherCAT state.
    pub struct CommunicationTransition {
        /// Its two letters, such as `PS`.
        pub id: String,
        /// The state before, by id.
        pub from: String,
        /// The state after, by id.
        pub to: String,
        /// What the device does.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
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
