//! PI C-887, C887T0011 of 3/14/2024, p. 8 to 13.

use devc_runtime::cia402::State::*;
use devc_runtime::cia402::{
    Command, Condition, Coupling::*, Edge, Events, Machine, ModeChange, Modes, Pattern, Refusal,
    StatePatterns, StateSet, Transition,
};

use super::{command, on_edge, transition};

pub(crate) const MACHINE: Machine = Machine {
    states: STATES,
    commands: COMMANDS,
    transitions: TRANSITIONS,
    conditions: &[
        Condition::caused(13, Events::FAULT),
        Condition::caused(14, Events::FAULT_REACTION_OVER),
        Condition::caused(1, Events::INITIALISED),
    ],
    refusal: Refusal::Fault,
    modes: Modes {
        supported: &[0, 6, 8],
        changes: &[
            ModeChange { from: &[0], to: &[8] },
            ModeChange { from: &[0], to: &[6] },
            ModeChange { from: &[8], to: &[] },
            ModeChange { from: &[6], to: &[] },
        ],
        selectable_in: StateSet::of(&[OperationEnabled]),
        refusal: Refusal::Fault,
    },
};

const STATES: StatePatterns = StatePatterns(&[
    (NotReadyToSwitchOn, Pattern { mask: 0x007F, value: 0x0000 }),
    (SwitchOnDisabled, Pattern { mask: 0x007F, value: 0x0040 }),
    (ReadyToSwitchOn, Pattern { mask: 0x007F, value: 0x0021 }),
    (SwitchedOn, Pattern { mask: 0x007F, value: 0x0033 }),
    (OperationEnabled, Pattern { mask: 0x007F, value: 0x0037 }),
    (QuickStopActive, Pattern { mask: 0x007F, value: 0x0017 }),
    (FaultReactionActive, Pattern { mask: 0x004F, value: 0x000F }),
    (Fault, Pattern { mask: 0x007F, value: 0x0008 }),
]);

const COMMANDS: &[Command] = &[
    command("shutdown", 0x0087, 0x0006, &[2, 6, 8]),
    command("switch on", 0x008F, 0x0007, &[3]),
    command("disable voltage", 0x0082, 0x0000, &[7, 9, 10, 12]),
    command("quick stop", 0x0086, 0x0002, &[11]),
    command("disable operation", 0x008F, 0x0007, &[5]),
    command("enable operation", 0x008F, 0x000F, &[4]),
    Command {
        ignored_in: StateSet::of(&[SwitchOnDisabled, FaultReactionActive]),
        ..on_edge(Edge::Rising(0x0080), command("fault reset", 0x0080, 0x0080, &[15]))
    },
];

const TRANSITIONS: &[Transition] = &[
    transition(0, &[], NotReadyToSwitchOn, All),
    transition(1, &[NotReadyToSwitchOn], SwitchOnDisabled, All),
    transition(2, &[SwitchOnDisabled], ReadyToSwitchOn, All),
    transition(3, &[ReadyToSwitchOn], SwitchedOn, All),
    transition(4, &[SwitchedOn], OperationEnabled, All),
    transition(5, &[OperationEnabled], SwitchedOn, Any),
    transition(6, &[SwitchedOn], ReadyToSwitchOn, Any),
    transition(7, &[ReadyToSwitchOn], SwitchOnDisabled, Any),
    transition(8, &[OperationEnabled], ReadyToSwitchOn, Any),
    transition(9, &[OperationEnabled], SwitchOnDisabled, Any),
    transition(10, &[SwitchedOn], SwitchOnDisabled, Any),
    transition(11, &[OperationEnabled], QuickStopActive, Any),
    transition(12, &[QuickStopActive], SwitchOnDisabled, Any),
    transition(
        13,
        &[
            NotReadyToSwitchOn,
            SwitchOnDisabled,
            ReadyToSwitchOn,
            SwitchedOn,
            OperationEnabled,
            QuickStopActive,
        ],
        FaultReactionActive,
        Any,
    ),
    transition(14, &[FaultReactionActive], Fault, All),
    // p. 12: from every state but switch on disabled and fault reaction active
    transition(
        15,
        &[NotReadyToSwitchOn, ReadyToSwitchOn, SwitchedOn, OperationEnabled, QuickStopActive, Fault],
        SwitchOnDisabled,
        All,
    ),
];
