//! The profile itself: the machine of a drive that follows CiA 402 to the letter.
//!
//! Generated modules have the same items with what the manual of their device says. These are for a drive without a
//! description, for what a description does not say, and for trying things out.

use super::State::{
    Fault, FaultReactionActive, NotReadyToSwitchOn, OperationEnabled, QuickStopActive, ReadyToSwitchOn,
    SwitchOnDisabled, SwitchedOn,
};
use super::{
    Command, Condition, Coupling, Edge, Machine, Modes, Pattern, Refusal, State, StatePatterns, StateSet,
    Transition,
};

/// The states in the statusword (CiA 402, statusword, state coding).
pub const STATES: StatePatterns = StatePatterns(&[
    (NotReadyToSwitchOn, Pattern { mask: 0x004F, value: 0x0000 }),
    (SwitchOnDisabled, Pattern { mask: 0x004F, value: 0x0040 }),
    (ReadyToSwitchOn, Pattern { mask: 0x006F, value: 0x0021 }),
    (SwitchedOn, Pattern { mask: 0x006F, value: 0x0023 }),
    (OperationEnabled, Pattern { mask: 0x006F, value: 0x0027 }),
    (QuickStopActive, Pattern { mask: 0x006F, value: 0x0007 }),
    (FaultReactionActive, Pattern { mask: 0x004F, value: 0x000F }),
    (Fault, Pattern { mask: 0x004F, value: 0x0008 }),
]);

/// The transitions, at the place of their number (CiA 402, PDS FSA transitions).
pub const TRANSITIONS: [Transition; 17] = [
    transition(0, &[], NotReadyToSwitchOn),
    transition(1, &[NotReadyToSwitchOn], SwitchOnDisabled),
    transition(2, &[SwitchOnDisabled], ReadyToSwitchOn),
    transition(3, &[ReadyToSwitchOn], SwitchedOn),
    transition(4, &[SwitchedOn], OperationEnabled),
    transition(5, &[OperationEnabled], SwitchedOn),
    transition(6, &[SwitchedOn], ReadyToSwitchOn),
    transition(7, &[ReadyToSwitchOn], SwitchOnDisabled),
    transition(8, &[OperationEnabled], ReadyToSwitchOn),
    transition(9, &[OperationEnabled], SwitchOnDisabled),
    transition(10, &[SwitchedOn], SwitchOnDisabled),
    transition(11, &[OperationEnabled], QuickStopActive),
    transition(12, &[QuickStopActive], SwitchOnDisabled),
    Transition {
        number: 13,
        from: StateSet::ALL.without(FaultReactionActive).without(Fault),
        to: FaultReactionActive,
        coupling: Coupling::Independent,
    },
    transition(14, &[FaultReactionActive], Fault),
    transition(15, &[Fault], SwitchOnDisabled),
    transition(16, &[QuickStopActive], OperationEnabled),
];

/// The commands (CiA 402, controlword, command coding).
pub const COMMANDS: [Command; 7] = [
    command("shutdown", 0x0087, 0x0006, &[2, 6, 8]),
    command("switch on", 0x008F, 0x0007, &[3]),
    command("disable voltage", 0x0082, 0x0000, &[7, 9, 10, 12]),
    command("quick stop", 0x0086, 0x0002, &[7, 10, 11]),
    command("disable operation", 0x008F, 0x0007, &[5]),
    command("enable operation", 0x008F, 0x000F, &[4, 16]),
    Command {
        name: "fault reset",
        pattern: Pattern { mask: 0x0080, value: 0x0080 },
        edge: Some(Edge::Rising(0x0080)),
        transitions: &[15],
        ignored_in: StateSet::NONE,
    },
];

/// The modes (CiA 402, modes of operation 0x6060), which may be chosen in every state.
pub const MODES: Modes = Modes {
    supported: &[0, 1, 2, 3, 4, 6, 7, 8, 9, 10],
    changes: &[],
    selectable_in: StateSet::ALL,
    refusal: Refusal::Ignored,
};

/// All of it (CiA 402, PDS FSA).
pub const MACHINE: Machine = Machine {
    states: STATES,
    commands: &COMMANDS,
    transitions: &TRANSITIONS,
    conditions: Condition::PROFILE,
    refusal: Refusal::Ignored,
    modes: MODES,
};

const fn transition(number: u8, from: &[State], to: State) -> Transition {
    Transition { number, from: StateSet::of(from), to, coupling: Coupling::Independent }
}

const fn command(name: &'static str, mask: u16, value: u16, transitions: &'static [u8]) -> Command {
    let ignored_in = StateSet::NONE;
    Command { name, pattern: Pattern { mask, value }, edge: None, transitions, ignored_in }
}
