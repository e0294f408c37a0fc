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
        /// The state before, by id; none for the start, or if it can come from several.
        pub from: Option<String>,
        /// The state after, by id.
        pub to: String,
        /// Whether it happens without a command.
        pub automatic: bool,
        /// Whether the device makes it at all.
        pub supported: bool,
        /// The bits of the controlword that set it off, where given for the transition itself.
        pub pattern: Option<Pattern>,
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
