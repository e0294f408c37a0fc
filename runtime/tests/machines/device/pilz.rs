//! Pilz PMC SC6/SI6, 1005347-en-US-02 of 02/2024, 6.5.2; A44 = 1: without the enable signal it makes a quick stop.

use devc_runtime::cia402::Coupling::Independent;
use devc_runtime::cia402::State::*;
use devc_runtime::cia402::{
    Command, Condition, Edge, Events, Machine, Modes, Refusal, StateSet, Transition, generic,
};

use super::{command, on_edge, transition};

/// The manual gives no coding of the states: the profile's.
pub(crate) const MACHINE: Machine = Machine {
    states: generic::STATES,
    commands: COMMANDS,
    transitions: TRANSITIONS,
    conditions: &[
        Condition::caused(13, Events::FAULT),
        Condition::caused(14, Events::FAULT_REACTION_OVER),
        Condition::caused(1, Events::INITIALISED),
        Condition::caused(7, Events::LOCKED_OUT.and(Events::NOT_ENABLED)),
        Condition::caused(9, Events::LOCKED_OUT),
        Condition::caused(10, Events::LOCKED_OUT.and(Events::NOT_ENABLED)),
        Condition::caused(11, Events::NOT_ENABLED),
        Condition::caused(12, Events::QUICK_STOP_OVER.and(Events::NOT_ENABLED)),
        Condition::hindered(2, Events::LOCKED_OUT.and(Events::NOT_ENABLED)),
        Condition::hindered(3, Events::NOT_ENABLED),
        Condition::hindered(4, Events::NOT_ENABLED),
        Condition::hindered(5, Events::NOT_ENABLED),
        Condition::hindered(6, Events::NOT_ENABLED),
        Condition::hindered(8, Events::NOT_ENABLED),
        Condition::hindered(15, Events::FAULT),
    ],
    refusal: Refusal::Ignored,
    modes: Modes {
        supported: &[-1, 0, 1, 2, 3, 4, 6, 7, 8, 9, 10],
        changes: &[],
        selectable_in: StateSet::ALL,
        refusal: Refusal::Ignored,
    },
};

const COMMANDS: &[Command] = &[
    command("shutdown", 0x0087, 0x0006, &[2, 6, 8]),
    command("switch on", 0x008F, 0x0007, &[3]),
    command("disable voltage", 0x0082, 0x0000, &[7, 9, 10]),
    command("quick stop", 0x0086, 0x0002, &[7, 10, 11]),
    command("disable operation", 0x008F, 0x0007, &[5]),
    command("enable operation", 0x008F, 0x000F, &[4]),
    on_edge(Edge::Rising(0x0080), command("fault reset", 0x0080, 0x0080, &[15])),
];

const TRANSITIONS: &[Transition] = &[
    transition(0, &[], NotReadyToSwitchOn, Independent),
    transition(1, &[NotReadyToSwitchOn], SwitchOnDisabled, Independent),
    transition(2, &[SwitchOnDisabled], ReadyToSwitchOn, Independent),
    transition(3, &[ReadyToSwitchOn], SwitchedOn, Independent),
    transition(4, &[SwitchedOn], OperationEnabled, Independent),
    transition(5, &[OperationEnabled], SwitchedOn, Independent),
    transition(6, &[SwitchedOn], ReadyToSwitchOn, Independent),
    transition(7, &[ReadyToSwitchOn], SwitchOnDisabled, Independent),
    transition(8, &[OperationEnabled], ReadyToSwitchOn, Independent),
    transition(9, &[OperationEnabled], SwitchOnDisabled, Independent),
    transition(10, &[SwitchedOn], SwitchOnDisabled, Independent),
    transition(11, &[OperationEnabled], QuickStopActive, Independent),
    transition(12, &[QuickStopActive], SwitchOnDisabled, Independent),
    generic::TRANSITIONS[13],
    transition(14, &[FaultReactionActive], Fault, Independent),
    transition(15, &[Fault], SwitchOnDisabled, Independent),
];
