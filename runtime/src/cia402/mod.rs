//! The power drive system of CiA 402 (IEC 61800-7-201): states, words, commands, transitions, modes, and the machines
//! of both sides.
//!
//! Names follow the profile. Bits follow the device: real drives deviate from the profile's tables, so each generated
//! module brings its own patterns, commands and transitions in the types of this module, together a [`Machine`].
//!
//! | side | runs | gives |
//! |---|---|---|
//! | the drive | [`Drive`] for an axis, [`Coupled`] for axes with one state, [`ModeSwitch`] | transitions, statusword, display of the mode |
//! | the master | [`Master`] for an axis, or for all that share a state; [`Observer`] to look on | controlword, mode, progress |
//! | the master, in a mode | [`Halt`], [`Homing`], [`SetPoints`] | the bits of the mode, progress |

mod command;
mod condition;
mod coupled;
mod drive;
mod events;
pub mod generic;
mod handshake;
mod homing_method;
mod machine;
mod master;
mod mode;
mod mode_switch;
mod modes;
mod observer;
mod pattern;
mod state;
mod state_patterns;
mod transition;

pub use command::{Command, Edge};
pub use condition::Condition;
pub use coupled::Coupled;
pub use drive::Drive;
pub use events::Events;
pub use handshake::{
    Halt, HaltProgress, Homing, HomingBits, HomingProgress, Move, SetPointProgress, SetPoints,
};
pub use homing_method::{Direction, HomingInfo, HomingMethod, homing_method};
pub use machine::{Cause, Machine, Refusal, Step};
pub use master::{Awaited, Feedback, Goal, Leave, Master, Output, Progress, Timing, Waiting, Withdrawal};
pub use mode::{Mode, UnknownMode};
pub use mode_switch::{ModeStep, ModeSwitch, Running};
pub use modes::{ModeChange, Modes};
pub use observer::Observer;
pub use pattern::Pattern;
pub use state::{State, StateSet};
pub use state_patterns::{StatePatterns, UnknownState};
pub use transition::{Coupling, Transition};
