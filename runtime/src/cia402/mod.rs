//! The power drive system of CiA 402 (IEC 61800-7-201): states, words, commands, transitions, modes.
//!
//! Names follow the profile. Bits follow the device: real drives deviate from the profile's tables, so each generated
//! module brings its own patterns, commands and transitions in the types of this module.

mod command;
mod mode;
mod pattern;
mod state;
mod state_patterns;
mod transition;

pub use command::{Command, Edge};
pub use mode::{Mode, UnknownMode};
pub use pattern::Pattern;
pub use state::{State, StateSet};
pub use state_patterns::{StatePatterns, UnknownState};
pub use transition::{Coupling, Transition};
