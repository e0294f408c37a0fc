//! The state machines of three drives, as a generated module states them.

pub(crate) mod c887;
pub(crate) mod pilz;
pub(crate) mod s700;

use devc_runtime::cia402::{Command, Coupling, Edge, Pattern, State, StateSet, Transition};

const fn transition(number: u8, from: &[State], to: State, coupling: Coupling) -> Transition {
    Transition { number, from: StateSet::of(from), to, coupling }
}

const fn command(name: &'static str, mask: u16, value: u16, transitions: &'static [u8]) -> Command {
    let ignored_in = StateSet::NONE;
    Command { name, pattern: Pattern { mask, value }, edge: None, transitions, ignored_in }
}

const fn on_edge(edge: Edge, command: Command) -> Command {
    Command { edge: Some(edge), ..command }
}
