//! The master against the drive, from every state to every goal.

use devc_runtime::cia402::State::{self, *};
use devc_runtime::cia402::{
    Awaited, Cause, Condition, Drive, Events, Feedback, Goal, Leave, Machine, Master, Output, Progress,
    Refusal, Timing, generic,
};

use crate::device::{c887, pilz, s700};
use crate::plant::{Dice, Plant, ROUND_TRIP};

/// Four machines, so strict that a word which is not for the state is a fault. The S700 follows bits, of which none is
/// wrong.
static STRICT: [Machine; 4] = [
    c887::MACHINE,
    Machine { refusal: Refusal::Fault, ..pilz::MACHINE },
    s700::MACHINE,
    Machine { refusal: Refusal::Fault, ..generic::MACHINE },
];

const TIMING: Timing = Timing { round_trip: ROUND_TRIP, resend: 60, timeout: 1000 };

/// Lines that differ.
const SEEDS: u64 = 30;

fn master(machine: &'static Machine) -> Master {
    Master::new(machine).timing(TIMING)
}

/// One cycle of both; the word must be one for the state that the master sees, even where the drive would ignore it.
fn cycle(machine: &'static Machine, master: &mut Master, plant: &mut Plant) -> Output {
    let feedback = plant.feedback();
    let output = master.cycle(feedback);
    let seen = master.state().unwrap_or(NotReadyToSwitchOn);
    let (before, now) = (plant.word(), output.controlword);
    let refusal = if follows_bits(machine) { Refusal::Ignored } else { Refusal::Fault };
    let step = Machine { refusal, ..*machine }.step(seen, (before, now), Events::NONE);
    let is_wrong = step.is_some_and(|step| matches!(step.cause, Cause::Refused { .. }));
    assert!(!is_wrong, "{seen}: {before:04X} {now:04X}");
    plant.run(&output);
    output
}

/// A drive to which each bit says something of its own, so that no word is wrong.
fn follows_bits(machine: &Machine) -> bool {
    machine.commands.iter().all(|command| command.edge.is_some() || command.triggers(2))
}

/// A drive that no command leads out of quick stop active leaves it by itself.
fn quick_stop_over(machine: &Machine) -> Events {
    let commanded = machine.commands.iter().any(|command| command.transitions.contains(&12));
    if commanded { Events::NONE } else { Events::QUICK_STOP_OVER }
}

fn is_faulty(state: State) -> bool {
    matches!(state, Fault | FaultReactionActive)
}

#[test]
fn every_goal_is_reached_from_every_state_in_bounded_steps() {
    for machine in &STRICT {
        for start in State::ALL {
            for goal in Goal::ALL {
                let mut plant = Plant::new(machine, start, None);
                plant.events = plant.events | quick_stop_over(machine);
                let mut master = master(machine);
                master.request(goal);
                let outputs: Vec<Output> = (0..24).map(|_| cycle(machine, &mut master, &mut plant)).collect();
                let last = outputs.last().unwrap().progress;
                assert_eq!(plant.refused(), None);
                assert_eq!(plant.rising(0x0080), 0);
                let is_enabled = plant.made.iter().any(|step| step.to == OperationEnabled);
                assert!(!is_enabled || goal == Goal::OperationEnabled, "no way through operation");
                if is_faulty(start) {
                    assert!(matches!(last, Progress::Withdrawn(_)), "{start} {goal:?} {last}");
                    assert_eq!(plant.drive.state(), Fault);
                } else {
                    assert_eq!(last, Progress::Reached, "{start} {goal:?}");
                    assert_eq!(plant.drive.state(), goal.state());
                }
            }
        }
    }
}

#[test]
fn the_way_out_of_operation_is_the_one_that_was_chosen() {
    for machine in &STRICT {
        for (leave, number) in [(Leave::DisableOperation, 5), (Leave::QuickStop, 11)] {
            for goal in [Goal::SwitchedOn, Goal::ReadyToSwitchOn, Goal::SwitchOnDisabled] {
                let mut plant = Plant::new(machine, OperationEnabled, None);
                plant.events = plant.events | quick_stop_over(machine);
                let mut master = master(machine).leaving_by(leave);
                master.request(goal);
                (0..40).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
                assert_eq!(plant.drive.state(), goal.state());
                assert_eq!(plant.made[0].number, number);
            }
        }
    }
}

#[test]
fn with_lost_late_and_repeated_frames_goals_are_reached_still() {
    for seed in 0..SEEDS {
        for machine in &STRICT {
            for start in State::ALL {
                for goal in Goal::ALL {
                    let mut plant = Plant::new(machine, start, Some(seed));
                    plant.events = plant.events | quick_stop_over(machine);
                    let mut master = master(machine);
                    master.request(goal);
                    let progress =
                        (0..400).map(|_| cycle(machine, &mut master, &mut plant).progress).last().unwrap();
                    let context = format!("seed {seed}, {start} to {goal:?}: {progress}, {:?}", plant.made);
                    assert_eq!(plant.refused(), None, "{context}");
                    assert_eq!(plant.rising(0x0080), 0, "{context}");
                    if is_faulty(start) {
                        assert!(matches!(progress, Progress::Withdrawn(_)), "{context}");
                    } else {
                        assert_eq!(progress, Progress::Reached, "{context}");
                        assert_eq!(plant.drive.state(), goal.state(), "{context}");
                    }
                }
            }
        }
    }
}

#[test]
fn requests_that_change_at_any_time_give_no_word_that_is_wrong_on_arrival() {
    for seed in 0..5 * SEEDS {
        for machine in &STRICT {
            let mut dice = Dice::new(seed + 1_000_000);
            let mut plant = Plant::new(machine, SwitchOnDisabled, Some(seed));
            let mut master = master(machine);
            for _ in 0..600 {
                match dice.below(40) {
                    chosen @ 0..4 => master.request(Goal::ALL[chosen as usize]),
                    4 => master.quick_stop(),
                    _ => (),
                }
                cycle(machine, &mut master, &mut plant);
                assert_eq!(plant.refused(), None, "seed {seed}, {:?}", plant.made);
            }
        }
    }
}

/// The drive jumps from state to state as it likes; `cycle` asserts that each word is one for the state that is seen.
#[test]
fn whatever_the_drive_does_no_word_is_wrong_for_the_state_that_it_shows() {
    for seed in 0..5 * SEEDS {
        for machine in &STRICT {
            let mut dice = Dice::new(seed + 2_000_000);
            let mut plant = Plant::new(machine, SwitchOnDisabled, Some(seed));
            let mut master = master(machine);
            for _ in 0..600 {
                match dice.below(40) {
                    chosen @ 0..4 => master.request(Goal::ALL[chosen as usize]),
                    4 => master.quick_stop(),
                    5 => _ = master.reset_fault(),
                    // not into operation, where the plant would have to be seeded
                    6 => {
                        let states =
                            State::ALL.map(|state| if state == OperationEnabled { Fault } else { state });
                        let state = states[dice.below(8) as usize];
                        plant.drive = plant.drive.resumed(state, plant.word());
                    }
                    _ => (),
                }
                cycle(machine, &mut master, &mut plant);
            }
        }
    }
}

#[test]
fn a_fault_is_reset_only_when_that_is_asked_for() {
    for seed in (0..SEEDS).map(Some).chain([None]) {
        for machine in &STRICT {
            let mut plant = Plant::new(machine, FaultReactionActive, seed);
            let mut master = master(machine);
            master.request(Goal::OperationEnabled);
            (0..200).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
            assert_eq!(plant.drive.state(), Fault);
            assert!(plant.sent.iter().all(|word| word & 0x0080 == 0));

            assert!(master.reset_fault());
            let progress = (0..400).map(|_| cycle(machine, &mut master, &mut plant).progress).last();
            assert_eq!(progress, Some(Progress::Reached), "{seed:?}");
            assert_eq!(plant.drive.state(), SwitchOnDisabled, "and no further");
            assert!(plant.rising(0x0080) >= 1);
            assert_eq!(plant.word(), 0x0000);
            assert!(!master.reset_fault());
        }
    }
}

/// Machines that reset a fault only when its cause is gone.
fn waiting() -> impl Iterator<Item = &'static Machine> {
    STRICT.iter().filter(|machine| machine.conditions.contains(&Condition::hindered(15, Events::FAULT)))
}

#[test]
fn a_fault_reset_is_a_pulse_however_long_the_fault_lasts() {
    for machine in waiting() {
        let mut plant = Plant::new(machine, Fault, None);
        plant.events = Events::FAULT;
        let mut master = master(machine);
        cycle(machine, &mut master, &mut plant);
        assert!(master.reset_fault());
        let outputs: Vec<Output> = (0..2000).map(|_| cycle(machine, &mut master, &mut plant)).collect();
        let pulses = plant.sent.split(|word| word & 0x0080 == 0).map(<[u16]>::len);
        assert!(plant.rising(0x0080) > 1);
        assert_eq!(pulses.max(), Some(usize::from(TIMING.round_trip)));
        // and after a time it is given up, so that no late repair resets it
        let last = outputs.last().unwrap();
        assert_eq!(last.progress.to_string(), "gave up: in fault, transition 15 by fault reset did not come");
        assert_eq!(last.controlword, 0);
        plant.events = Events::NONE;
        (0..500).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
        assert_eq!(plant.drive.state(), Fault);
    }
}

/// A button that is held is one wish: no second pulse for it, and no more time.
#[test]
fn a_request_that_is_repeated_is_the_same_request() {
    for machine in waiting() {
        let sent = |repeated: bool| {
            let mut plant = Plant::new(machine, Fault, None);
            plant.events = Events::FAULT;
            let mut master = master(machine);
            cycle(machine, &mut master, &mut plant);
            for now in 0..900 {
                if now == 0 || repeated {
                    assert!(master.reset_fault());
                }
                cycle(machine, &mut master, &mut plant);
            }
            plant.sent
        };
        assert_eq!(sent(true), sent(false));
    }
}

/// Runs to operation, and lets something happen there after a time.
fn operating(machine: &'static Machine, seed: Option<u64>) -> (Master, Plant) {
    let mut plant = Plant::new(machine, SwitchOnDisabled, seed);
    let mut master = master(machine);
    master.request(Goal::OperationEnabled);
    let progress = (0..400).map(|_| cycle(machine, &mut master, &mut plant).progress).last();
    assert_eq!(progress, Some(Progress::Reached));
    (master, plant)
}

#[test]
fn after_a_quick_stop_of_the_master_nothing_is_enabled_without_a_request() {
    for seed in (0..SEEDS).map(Some).chain([None]) {
        for machine in &STRICT {
            let (mut master, mut plant) = operating(machine, seed);
            master.quick_stop();
            (0..100).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
            assert_eq!(plant.drive.state(), QuickStopActive);
            plant.events = plant.events | Events::QUICK_STOP_OVER;
            plant.made.clear();
            (0..1000).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
            assert!(plant.made.iter().all(|step| step.to == SwitchOnDisabled), "{:?}", plant.made);

            master.request(Goal::OperationEnabled);
            (0..400).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
            assert_eq!(plant.drive.state(), OperationEnabled);
        }
    }
}

#[test]
fn after_a_fault_or_a_stop_by_a_signal_nothing_is_enabled_without_a_request() {
    let machine = &pilz::MACHINE;
    for (event, name) in [
        (Events::FAULT, "fault reaction active"),
        (Events::NOT_ENABLED, "quick stop active"),
        (Events::LOCKED_OUT, "switch on disabled"),
    ] {
        for seed in (0..SEEDS).map(Some).chain([None]) {
            let (mut master, mut plant) = operating(machine, seed);
            let usual = plant.events;
            plant.events = usual | event;
            let output = (0..60).map(|_| cycle(machine, &mut master, &mut plant)).last().unwrap();
            assert!(matches!(output.progress, Progress::Withdrawn(_)), "{}", output.progress);
            if seed.is_none() {
                let text =
                    format!("operation enabled withdrawn: the drive went from operation enabled to {name}");
                assert_eq!(output.progress.to_string(), text);
            }
            plant.events = usual;
            plant.made.clear();
            (0..1000).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
            if event == Events::FAULT {
                assert!(master.reset_fault());
            }
            (0..1000).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
            assert!(plant.made.iter().all(|step| step.to == SwitchOnDisabled), "{:?}", plant.made);
            assert_eq!(plant.drive.state(), SwitchOnDisabled);
        }
    }
}

/// A drive that goes on from a quick stop by enable operation, stopped by its own means just as the master enables it.
#[test]
fn a_quick_stop_on_the_way_ends_the_request() {
    let machine = &STRICT[3];
    let mut plant = Plant::new(machine, SwitchedOn, None);
    let mut master = master(machine);
    master.request(Goal::OperationEnabled);
    (0..2).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
    plant.drive = plant.drive.resumed(QuickStopActive, 0x000F);
    (0..1000).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
    assert_eq!(plant.drive.state(), QuickStopActive);
}

/// The request came after the quick stop, so that its end is no reason to withdraw it.
#[test]
fn a_quick_stop_that_ends_after_the_request_does_not_end_it() {
    for machine in [&pilz::MACHINE, &generic::MACHINE] {
        let mut plant = Plant::new(machine, QuickStopActive, None);
        plant.seeds = false;
        let mut master = master(machine);
        master.request(Goal::OperationEnabled);
        (0..5).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
        assert_eq!(plant.drive.state(), QuickStopActive);
        plant.events = plant.events | Events::QUICK_STOP_OVER;
        plant.seeds = true;
        (0..20).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
        assert_eq!(plant.drive.state(), OperationEnabled);
    }
}

#[test]
fn no_axis_jumps_when_it_is_enabled() {
    // the plant asserts it: its target is 0 until it is seeded, its position 1000 and falling
    for seed in (0..SEEDS).map(Some).chain([None]) {
        for machine in &STRICT {
            operating(machine, seed);
        }
    }
}

#[test]
fn without_seeds_no_axis_is_enabled() {
    for machine in &STRICT {
        let mut plant = Plant::new(machine, SwitchOnDisabled, None);
        plant.seeds = false;
        let mut master = master(machine);
        master.request(Goal::OperationEnabled);
        let outputs: Vec<Output> = (0..2000).map(|_| cycle(machine, &mut master, &mut plant)).collect();
        assert!(plant.made.iter().all(|step| step.to != OperationEnabled));
        assert!(outputs.iter().all(|output| output.seed && !output.motion));
        let Progress::Overdue(waiting) = outputs.last().unwrap().progress else { panic!() };
        assert_eq!((waiting.state, waiting.awaits), (Some(SwitchedOn), Awaited::Seed));
    }
}

#[test]
fn seeds_of_an_earlier_request_do_not_count() {
    for machine in &STRICT {
        let (mut master, mut plant) = operating(machine, None);
        master.request(Goal::SwitchedOn);
        plant.seeds = false;
        (0..100).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
        assert_eq!(plant.drive.state(), SwitchedOn);
        master.request(Goal::OperationEnabled);
        (0..100).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
        assert_eq!(plant.drive.state(), SwitchedOn);
    }
}

#[test]
fn there_is_no_motion_before_the_mode_is_displayed() {
    for seed in (0..SEEDS).map(Some).chain([None]) {
        for machine in &STRICT {
            let mut plant = Plant::new(machine, SwitchOnDisabled, seed);
            let mut master = master(machine);
            master.request(Goal::OperationEnabled);
            for mode in [8, 6, 8] {
                master.select(mode).unwrap();
                for _ in 0..400 {
                    let output = cycle(machine, &mut master, &mut plant);
                    assert!(!output.motion || plant.mode.display() == mode);
                }
                assert_eq!((plant.drive.state(), plant.mode.display()), (OperationEnabled, mode));
            }
        }
    }
}

#[test]
fn a_mode_that_never_comes_is_reported_and_ends_in_no_motion() {
    for machine in &STRICT {
        let mut master = master(machine);
        master.select(8).unwrap();
        master.request(Goal::OperationEnabled);
        let mut drive = Drive::new(machine).resumed(SwitchOnDisabled, 0);
        let mut last = None;
        for _ in 0..3000 {
            let output = master.cycle(Feedback { statusword: drive.statusword(0), mode: 0, seeded: true });
            assert!(!output.motion);
            drive.cycle(output.controlword, Events::NONE);
            last = Some(output.progress);
        }
        let Some(Progress::Overdue(waiting)) = last else { panic!("{last:?}") };
        assert_eq!(waiting.awaits, Awaited::Mode { asked: 8, displayed: 0 });
        assert_ne!(drive.state(), OperationEnabled);
    }
}

#[test]
fn only_modes_of_the_device_can_be_selected() {
    for machine in &STRICT {
        for mode in i8::MIN..=i8::MAX {
            assert_eq!(master(machine).select(mode).is_ok(), machine.modes.has(mode));
        }
    }
}

#[test]
fn what_does_not_come_is_named() {
    let machine = &pilz::MACHINE;
    let mut plant = Plant::new(machine, SwitchOnDisabled, None);
    plant.events = Events::NOT_ENABLED;
    let mut master = master(machine);
    master.request(Goal::OperationEnabled);
    let outputs: Vec<Output> = (0..1200).map(|_| cycle(machine, &mut master, &mut plant)).collect();
    assert_eq!(
        outputs[500].progress.to_string(),
        "waiting: in switch on disabled, transition 2 by shutdown has not come yet"
    );
    assert_eq!(
        outputs[1100].progress.to_string(),
        "gave up: in switch on disabled, transition 2 by shutdown did not come"
    );
    // what comes too late does not enable the drive either
    plant.events = Events::NONE;
    (0..100).for_each(|_| _ = cycle(machine, &mut master, &mut plant));
    assert_eq!(plant.drive.state(), SwitchOnDisabled);
}

#[test]
fn a_statusword_without_a_state_gives_nothing_new_and_in_the_end_no_power() {
    for machine in &STRICT {
        let (mut master, plant) = operating(machine, None);
        let word = plant.word();
        let unknown = (0..=u16::MAX).find(|word| machine.states.fitting(*word).is_empty()).unwrap();
        let outputs: Vec<Output> = (0..1200)
            .map(|_| master.cycle(Feedback { statusword: unknown, mode: 0, seeded: true }))
            .collect();
        assert!(outputs.iter().skip(usize::from(TIMING.round_trip)).all(|output| !output.motion));
        assert_eq!(outputs[500].controlword, word);
        let last = outputs.last().unwrap();
        assert_eq!(last.controlword, 0x0000);
        assert!(matches!(last.progress, Progress::Overdue(_)));
    }
}

#[test]
fn without_a_request_nothing_is_enabled_and_what_is_enabled_is_not_left_so() {
    for machine in &STRICT {
        for start in State::ALL {
            let mut plant = Plant::new(machine, start, None);
            let mut master = master(machine);
            let outputs: Vec<Output> = (0..100).map(|_| cycle(machine, &mut master, &mut plant)).collect();
            assert!(plant.made.iter().all(|step| step.to != OperationEnabled));
            assert_eq!(outputs.last().unwrap().progress, Progress::Idle);
            let expected = match start {
                OperationEnabled => SwitchedOn,
                NotReadyToSwitchOn => SwitchOnDisabled,
                FaultReactionActive => Fault,
                other => other,
            };
            assert_eq!(plant.drive.state(), expected);
        }
    }
}
