//! Every state with every controlword, after every word that matters for its edges.

use std::sync::OnceLock;

use devc_runtime::cia402::State::{self, *};
use devc_runtime::cia402::{Cause, Command, Drive, Events, Machine, StateSet, Step, generic};

use crate::device::{c887, pilz, s700};

/// Bits 7, 3, 2, 1, 0 of the controlword as a table prints them: `^` rises, `v` falls, `x` does not matter.
struct Row {
    mask: u16,
    value: u16,
    rising: u16,
    falling: u16,
}

impl Row {
    fn parse(printed: &str) -> Self {
        let mut row = Self { mask: 0, value: 0, rising: 0, falling: 0 };
        assert_eq!(printed.len(), 5);
        for (sign, bit) in printed.chars().zip([7, 3, 2, 1, 0]) {
            let bit = 1 << bit;
            match sign {
                '0' => row.mask |= bit,
                '1' => (row.mask, row.value) = (row.mask | bit, row.value | bit),
                '^' => row.rising |= bit,
                'v' => row.falling |= bit,
                other => assert_eq!(other, 'x', "{printed}"),
            }
        }
        row
    }

    fn fits(&self, previous: u16, current: u16) -> bool {
        (current ^ self.value) & self.mask == 0
            && !previous & current & self.rising == self.rising
            && previous & !current & self.falling == self.falling
    }
}

/// What a manual says of a state: rows of bits, and where they lead.
type Table = [(State, &'static [(&'static str, State)]); 8];

/// C887T0011: figure 6 with figure 4 and the text below figure 6. What is not permitted is a fault (13); 16 is not
/// supported; a fault reset acts everywhere but in two states; only its rising edge counts, not its being held.
const C887: Table = [
    (NotReadyToSwitchOn, &[("^xxxx", SwitchOnDisabled)]),
    (
        SwitchOnDisabled,
        &[
            ("0x110", ReadyToSwitchOn),
            ("00111", FaultReactionActive),
            ("01111", FaultReactionActive),
            ("0x01x", FaultReactionActive),
        ],
    ),
    (
        ReadyToSwitchOn,
        &[
            ("^xxxx", SwitchOnDisabled),
            ("00111", SwitchedOn),
            ("01111", FaultReactionActive),
            ("0xx0x", SwitchOnDisabled),
            ("0x01x", FaultReactionActive),
        ],
    ),
    (
        SwitchedOn,
        &[
            ("^xxxx", SwitchOnDisabled),
            ("0x110", ReadyToSwitchOn),
            ("01111", OperationEnabled),
            ("0xx0x", SwitchOnDisabled),
            ("0x01x", FaultReactionActive),
        ],
    ),
    (
        OperationEnabled,
        &[
            ("^xxxx", SwitchOnDisabled),
            ("0x110", ReadyToSwitchOn),
            ("00111", SwitchedOn),
            ("0xx0x", SwitchOnDisabled),
            ("0x01x", QuickStopActive),
        ],
    ),
    (
        QuickStopActive,
        &[
            ("^xxxx", SwitchOnDisabled),
            ("0x110", FaultReactionActive),
            ("00111", FaultReactionActive),
            ("01111", FaultReactionActive),
            ("0xx0x", SwitchOnDisabled),
        ],
    ),
    (FaultReactionActive, &[]),
    (Fault, &[("^xxxx", SwitchOnDisabled)]),
];

/// 1005347: table 5 with 6.5.2.2 to 6.5.2.9; the commands disable voltage and quick stop are causes of switch on
/// disabled (6.5.2.3).
const PILZ: Table = [
    (NotReadyToSwitchOn, &[]),
    (SwitchOnDisabled, &[("0x110", ReadyToSwitchOn)]),
    (ReadyToSwitchOn, &[("00111", SwitchedOn), ("0xx0x", SwitchOnDisabled), ("0x01x", SwitchOnDisabled)]),
    (
        SwitchedOn,
        &[
            ("01111", OperationEnabled),
            ("0x110", ReadyToSwitchOn),
            ("0xx0x", SwitchOnDisabled),
            ("0x01x", SwitchOnDisabled),
        ],
    ),
    (
        OperationEnabled,
        &[
            ("0x01x", QuickStopActive),
            ("00111", SwitchedOn),
            ("0x110", ReadyToSwitchOn),
            ("0xx0x", SwitchOnDisabled),
        ],
    ),
    (QuickStopActive, &[]),
    (FaultReactionActive, &[]),
    (Fault, &[("^xxxx", SwitchOnDisabled)]),
];

/// The table of 3.4.2, row by row.
const S700: Table = [
    (NotReadyToSwitchOn, &[]),
    (SwitchOnDisabled, &[("xxx10", ReadyToSwitchOn)]),
    (ReadyToSwitchOn, &[("xx11^", SwitchedOn), ("xxxvx", SwitchOnDisabled)]),
    (SwitchedOn, &[("x^111", OperationEnabled), ("xxx1v", ReadyToSwitchOn), ("xxxvx", SwitchOnDisabled)]),
    (
        OperationEnabled,
        &[
            ("xv111", SwitchedOn),
            ("xxx1v", ReadyToSwitchOn),
            ("xxxvx", SwitchOnDisabled),
            ("x1v11", QuickStopActive),
        ],
    ),
    (QuickStopActive, &[("xxxvx", SwitchOnDisabled), ("x1^11", OperationEnabled)]),
    (FaultReactionActive, &[]),
    (Fault, &[("^xxxx", SwitchOnDisabled)]),
];

/// Every word after every word that differs from it in the bits with edges, each way.
fn compare(machine: &'static Machine, table: &Table, edges: &[u16]) {
    for (state, rows) in table {
        let rows: Vec<(Row, State)> = rows.iter().map(|(row, to)| (Row::parse(row), *to)).collect();
        for current in 0..=u16::MAX {
            for changed in edges {
                let previous = current ^ changed;
                let mut printed =
                    rows.iter().filter(|(row, _)| row.fits(previous, current)).map(|(_, to)| *to);
                let expected = printed.next().unwrap_or(*state);
                assert_eq!(printed.next(), None, "{state}: {previous:04X} {current:04X} is in two rows");
                let mut drive = Drive::new(machine).resumed(*state, previous);
                let step = drive.cycle(current, Events::NONE);
                assert_eq!(drive.state(), expected, "{state}: {previous:04X} {current:04X} {step:?}");
                assert_eq!(step.map_or(*state, |step| step.to), expected);
            }
        }
    }
}

/// All ways in which these bits may have changed.
fn changes(bits: u16) -> Vec<u16> {
    (0..=bits).filter(|change| change & !bits == 0).collect()
}

#[test]
fn the_c887_makes_the_transitions_of_its_manual() {
    compare(&c887::MACHINE, &C887, &[0x0000, 0x0080, 0x000F, 0xFF7F, 0xFFFF]);
}

#[test]
fn the_pilz_drive_makes_the_transitions_of_its_manual() {
    compare(&pilz::MACHINE, &PILZ, &[0x0000, 0x0080, 0x000F, 0xFF7F, 0xFFFF]);
}

#[test]
fn the_s700_makes_the_transitions_of_its_manual() {
    compare(&s700::MACHINE, &S700, &changes(0x008F));
}

/// What a drive does when something happens, whatever word it has.
fn happens(machine: &'static Machine, from: State, events: Events) -> Option<Step> {
    let mut first = None;
    for word in 0..=u16::MAX {
        let step = Drive::new(machine).resumed(from, word).cycle(word, events);
        if word == 0 {
            first = step;
        }
        assert_eq!(step, first, "{from}, {word:04X}");
    }
    first
}

#[test]
fn a_fault_leads_from_every_state_into_its_reaction_and_from_there_to_fault() {
    for machine in [&c887::MACHINE, &pilz::MACHINE, &s700::MACHINE, &generic::MACHINE] {
        for state in State::ALL {
            let made = happens(machine, state, Events::FAULT).map(|step| (step.number, step.to));
            let expected =
                (!matches!(state, Fault | FaultReactionActive)).then_some((13, FaultReactionActive));
            assert_eq!(made, expected, "{state}");
        }
        let over = happens(machine, FaultReactionActive, Events::FAULT_REACTION_OVER);
        assert_eq!(over.map(|step| (step.number, step.to)), Some((14, Fault)));
    }
}

#[test]
fn a_drive_leaves_not_ready_by_itself() {
    for machine in [&c887::MACHINE, &pilz::MACHINE, &s700::MACHINE, &generic::MACHINE] {
        let made = happens(machine, NotReadyToSwitchOn, Events::INITIALISED);
        assert_eq!(made.map(|step| (step.number, step.to)), Some((1, SwitchOnDisabled)));
    }
}

#[test]
fn a_fault_is_reset_by_an_edge_and_only_when_its_cause_is_gone() {
    for machine in [&pilz::MACHINE, &generic::MACHINE] {
        for word in 0..=u16::MAX {
            let low = word & !0x0080;
            let mut drive = Drive::new(machine).resumed(Fault, low);
            assert_eq!(drive.cycle(low | 0x0080, Events::FAULT), None, "the cause is still there");
            assert_eq!(drive.cycle(low | 0x0080, Events::NONE), None, "held");
            assert_eq!(drive.cycle(low, Events::NONE), None, "falls");
            let step = drive.cycle(low | 0x0080, Events::NONE).unwrap();
            assert_eq!((step.number, step.to), (15, SwitchOnDisabled));
            assert_eq!(step.cause, Cause::Command("fault reset"));
        }
    }
}

/// P. 12 of the C-887: the reset is made in every state but two, and nothing is said of the cause.
#[test]
fn the_c887_resets_a_fault_whatever_its_cause_does() {
    let mut drive = Drive::new(&c887::MACHINE).resumed(Fault, 0);
    let step = drive.cycle(0x0080, Events::FAULT).unwrap();
    assert_eq!((step.number, step.to), (15, SwitchOnDisabled));
}

#[test]
fn a_bit_that_is_set_at_power_on_is_no_edge() {
    let mut drive = Drive::new(&c887::MACHINE);
    assert_eq!(drive.cycle(0x0080, Events::NONE), None);
    assert_eq!(drive.state(), NotReadyToSwitchOn);
}

/// 6.5.2.3 to 6.5.2.7 of 1005347, with A44 = 1.
#[test]
fn the_pilz_drive_follows_its_enable_signal() {
    let expected = |state| match state {
        ReadyToSwitchOn => Some((7, SwitchOnDisabled)),
        SwitchedOn => Some((10, SwitchOnDisabled)),
        OperationEnabled => Some((11, QuickStopActive)),
        QuickStopActive => Some((12, SwitchOnDisabled)),
        _ => None,
    };
    for state in State::ALL {
        let made = happens(&pilz::MACHINE, state, Events::NOT_ENABLED);
        assert_eq!(made.map(|step| (step.number, step.to)), expected(state));
    }
    for word in 0..=u16::MAX {
        let mut drive = Drive::new(&pilz::MACHINE).resumed(SwitchOnDisabled, word);
        assert_eq!(drive.cycle(0x0006, Events::NOT_ENABLED), None);
        assert_eq!(drive.cycle(0x0006, Events::NONE).map(|step| step.number), Some(2));
    }
}

#[test]
fn only_the_pilz_drive_ends_its_quick_stop_by_itself() {
    let over = happens(&pilz::MACHINE, QuickStopActive, Events::QUICK_STOP_OVER).map(|step| step.number);
    assert_eq!(over, Some(12));
    for machine in [&c887::MACHINE, &s700::MACHINE] {
        for word in 0..=u16::MAX {
            let step = |events| Drive::new(machine).resumed(QuickStopActive, word).cycle(word, events);
            assert_eq!(step(Events::QUICK_STOP_OVER), step(Events::NONE));
        }
    }
}

#[test]
fn every_state_is_shown_whatever_the_other_bits_are() {
    for machine in [&c887::MACHINE, &pilz::MACHINE, &s700::MACHINE, &generic::MACHINE] {
        for state in State::ALL {
            for bits in 0..=u16::MAX {
                let word = Drive::new(machine).resumed(state, 0).statusword(bits);
                assert!(machine.states.fitting(word).contains(state), "{state} {word:04X}");
            }
        }
    }
}

/// Where a manual says that a command is ignored, it is, however strict the drive is otherwise.
#[test]
fn a_command_that_is_ignored_is_no_fault() {
    let ignored_in = StateSet::of(&[ReadyToSwitchOn, SwitchedOn]);
    for (state, (previous, current)) in [(ReadyToSwitchOn, (0x0006, 0x000F)), (SwitchedOn, (0x0007, 0x0002))]
    {
        let step =
            |commands| Machine { commands, ..c887::MACHINE }.step(state, (previous, current), Events::NONE);
        assert_eq!(step(c887::MACHINE.commands).map(|step| step.number), Some(13), "{state}");
        static PATIENT: OnceLock<Vec<Command>> = OnceLock::new();
        let patient =
            || c887::MACHINE.commands.iter().map(|command| Command { ignored_in, ..*command }).collect();
        assert_eq!(step(PATIENT.get_or_init(patient)), None, "{state}");
    }
}
