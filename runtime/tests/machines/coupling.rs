//! The axes of the C-887, C887T0011, p. 10.

use devc_runtime::cia402::State::{self, *};
use devc_runtime::cia402::{
    Cause, Condition, Coupled, Drive, Events, Feedback, Goal, Machine, Master, ModeSwitch, Running, Timing,
};

use crate::device::c887::MACHINE;
use crate::plant::{Dice, Line, ROUND_TRIP};

const AXES: usize = 6;

/// Axes that take a fault and axes that have none: every combination of the six.
fn on_axes(chosen: usize, event: Events) -> [Events; AXES] {
    core::array::from_fn(|axis| if chosen >> axis & 1 == 1 { event } else { Events::NONE })
}

#[test]
fn axes_without_events_are_as_one() {
    for state in State::ALL {
        for current in 0..=u16::MAX {
            for previous in [current, current ^ 0x0080] {
                let mut one = Drive::new(&MACHINE).resumed(state, previous);
                let mut six = Coupled::<AXES>::resumed(&MACHINE, state, previous);
                let step = one.cycle(current, Events::NONE);
                assert_eq!(six.cycle(current, [Events::NONE; AXES]), step);
                assert_eq!(six.state(), one.state());
                assert_eq!(six.statusword(0), one.statusword(0));
            }
        }
    }
}

#[test]
fn a_fault_of_any_axes_stops_all() {
    for state in State::ALL {
        for chosen in 1..1 << AXES {
            // whatever the others are asked for at the same time
            for word in [0x0000, 0x0002, 0x0006, 0x0007, 0x000F] {
                let mut axes = Coupled::<AXES>::resumed(&MACHINE, state, word);
                axes.cycle(word, on_axes(chosen, Events::FAULT));
                let expected = if state == Fault { Fault } else { FaultReactionActive };
                assert_eq!(axes.state(), expected, "{state} {chosen:06b} {word:04X}");
                assert_eq!(axes.axes(), &[expected; AXES]);
            }
        }
    }
}

#[test]
fn start_and_the_end_of_a_fault_reaction_take_all_axes() {
    for (from, event, to) in [
        (NotReadyToSwitchOn, Events::INITIALISED, SwitchOnDisabled),
        (FaultReactionActive, Events::FAULT_REACTION_OVER, Fault),
    ] {
        for first in 0..1 << AXES {
            let all = (1 << AXES) - 1;
            let mut axes = Coupled::<AXES>::resumed(&MACHINE, from, 0);
            axes.cycle(0, on_axes(first, event));
            assert_eq!(axes.state(), if first == all { to } else { from });
            axes.cycle(0, on_axes(all & !first, event));
            assert_eq!(axes.state(), to, "{first:06b}");
        }
    }
}

#[test]
fn axes_that_are_ahead_wait_for_the_others() {
    let all = (1 << AXES) - 1;
    for first in 1..all {
        let mut axes = Coupled::<AXES>::resumed(&MACHINE, NotReadyToSwitchOn, 0x0006);
        for _ in 0..5 {
            axes.cycle(0x0006, on_axes(first, Events::INITIALISED));
            assert_eq!(axes.state(), NotReadyToSwitchOn);
        }
        let numbers: Vec<u8> = (0..3)
            .filter_map(|_| axes.cycle(0x0006, on_axes(all, Events::INITIALISED)))
            .map(|step| step.number)
            .collect();
        assert_eq!(numbers, [1, 2], "{first:06b}");
        assert_eq!(axes.axes(), &[ReadyToSwitchOn; AXES]);
    }
}

/// A device coupled like the C-887, but one that resets a fault only when its cause is gone.
const WAITING: Machine = Machine { conditions: &[Condition::hindered(15, Events::FAULT)], ..MACHINE };

#[test]
fn a_reset_takes_all_axes_and_an_edge_for_each_that_was_not_ready() {
    for stuck in 1..1 << AXES {
        let mut axes = Coupled::<AXES>::resumed(&WAITING, Fault, 0);
        axes.cycle(0x0080, on_axes(stuck, Events::FAULT));
        assert_eq!(axes.state(), Fault, "{stuck:06b}");
        axes.cycle(0x0080, [Events::NONE; AXES]);
        assert_eq!(axes.state(), Fault, "a reset that is held");
        axes.cycle(0x0000, [Events::NONE; AXES]);
        axes.cycle(0x0080, [Events::NONE; AXES]);
        assert_eq!(axes.state(), SwitchOnDisabled);
    }
}

/// One master leads the platform by the first axis' words, over a line that loses frames.
#[test]
fn one_master_enables_six_axes_and_stops_when_one_fails() {
    for seed in 0..100 {
        let mut dice = Dice::new(seed);
        let mut axes = Coupled::<AXES>::new(&MACHINE);
        let mut mode = ModeSwitch::new(&MACHINE.modes);
        let (mut down, mut up) = (Line::new((0, 0)), Line::new((axes.statusword(0), 0)));
        let mut master =
            Master::new(&MACHINE).timing(Timing { round_trip: ROUND_TRIP, resend: 60, timeout: 1000 });
        master.select(8).unwrap();
        master.request(Goal::OperationEnabled);
        let (mut seeded, mut motion) = (false, false);
        for now in 0..600 {
            // each axis takes its time to start, and one fails in the end
            let events = core::array::from_fn(|axis| match now {
                0..300 if now < 10 * axis => Events::NONE,
                400..500 if axis == 4 => Events::INITIALISED | Events::FAULT,
                _ => Events::INITIALISED | Events::FAULT_REACTION_OVER,
            });
            let (statusword, display) = up.carry((axes.statusword(0), mode.display()), Some(&mut dice));
            let output = master.cycle(Feedback { statusword, mode: display, seeded });
            seeded = output.seed;
            motion |= output.motion;
            assert!(!output.motion || now > 50 && mode.display() == 8);
            let (word, asked) = down.carry((output.controlword, output.mode), Some(&mut dice));
            let step = axes.cycle(word, events);
            assert!(
                !step.is_some_and(|step| matches!(step.cause, Cause::Refused { .. })),
                "seed {seed}: {step:?}"
            );
            mode.cycle(asked, axes.state(), Running::Over);
            if now == 399 {
                assert_eq!((axes.state(), motion), (OperationEnabled, true), "seed {seed}");
            }
        }
        assert_eq!(axes.axes(), &[Fault; AXES]);
    }
}
