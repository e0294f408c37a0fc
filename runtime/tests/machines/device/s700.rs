//! Kollmorgen S700, EtherCAT manual 07/2016, 3.4: single bits of the controlword, most of them by their edges.

use devc_runtime::cia402::State::*;
use devc_runtime::cia402::{
    Command, Condition, Edge, Events, Machine, Modes, Pattern, Refusal, StatePatterns, StateSet, generic,
};

use super::{command, on_edge};

pub(crate) const MACHINE: Machine = Machine {
    states: STATES,
    commands: COMMANDS,
    transitions: &generic::TRANSITIONS,
    conditions: CONDITIONS,
    refusal: Refusal::Ignored,
    modes: Modes {
        // 3.8: each mode has a second number, the manufacturer's
        supported: &[-7, -6, -3, -2, 6, 8, 9, 10],
        changes: &[],
        selectable_in: StateSet::ALL,
        refusal: Refusal::Ignored,
    },
};

/// But for three rows as printed: the manual has the same pattern for the first two states, which CiA 402 tells apart by
/// bit 6; it prints Quick stop active without bit 2, which the profile sets, so that either is taken; and it prints Fault
/// with bit 5, which it shows only after a rising edge of bit 2 of the controlword, so that either is taken.
const STATES: StatePatterns = StatePatterns(&[
    (NotReadyToSwitchOn, Pattern { mask: 0x004F, value: 0x0000 }),
    (SwitchOnDisabled, Pattern { mask: 0x004F, value: 0x0040 }),
    (ReadyToSwitchOn, Pattern { mask: 0x004F, value: 0x0001 }),
    (SwitchedOn, Pattern { mask: 0x006F, value: 0x0023 }),
    (OperationEnabled, Pattern { mask: 0x006F, value: 0x0027 }),
    (QuickStopActive, Pattern { mask: 0x006B, value: 0x0003 }),
    (FaultReactionActive, Pattern { mask: 0x006F, value: 0x000F }),
    (Fault, Pattern { mask: 0x004F, value: 0x0008 }),
]);

/// The profile's own, of transitions that the drive makes by itself: the manual names no events, and after a quick stop
/// the drive stays enabled (3.4.2, bit 2).
const CONDITIONS: &[Condition] = &[
    Condition::caused(13, Events::FAULT),
    Condition::caused(14, Events::FAULT_REACTION_OVER),
    Condition::caused(1, Events::INITIALISED),
];

/// One for each transition that bits make; 1, 13 and 14 the drive makes by itself.
const COMMANDS: &[Command] = &[
    command("shutdown", 0x0003, 0x0002, &[2]),
    on_edge(Edge::Rising(0x0001), command("switch on", 0x0007, 0x0007, &[3])),
    on_edge(Edge::Rising(0x0008), command("enable operation", 0x000F, 0x000F, &[4])),
    on_edge(Edge::Falling(0x0008), command("disable operation", 0x000F, 0x0007, &[5])),
    on_edge(Edge::Falling(0x0001), command("shutdown", 0x0003, 0x0002, &[6])),
    on_edge(Edge::Falling(0x0002), command("disable voltage", 0x0002, 0x0000, &[7])),
    on_edge(Edge::Falling(0x0001), command("shutdown", 0x0003, 0x0002, &[8])),
    on_edge(Edge::Falling(0x0002), command("disable voltage", 0x0002, 0x0000, &[9])),
    on_edge(Edge::Falling(0x0002), command("disable voltage", 0x0002, 0x0000, &[10])),
    on_edge(Edge::Falling(0x0004), command("quick stop", 0x000F, 0x000B, &[11])),
    on_edge(Edge::Falling(0x0002), command("disable voltage", 0x0002, 0x0000, &[12])),
    on_edge(Edge::Rising(0x0080), command("fault reset", 0x0080, 0x0080, &[15])),
    on_edge(Edge::Rising(0x0004), command("enable operation", 0x000F, 0x000F, &[16])),
];
