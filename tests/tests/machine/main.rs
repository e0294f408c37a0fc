//! The state machines that devc generates against machines made by hand from the manuals: every word, in every state,
//! after every word that matters for its edges, whatever happens in the drive.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic)] // a test may

#[expect(dead_code, reason = "it is shared with tests that need more of it")]
#[path = "../described/mod.rs"]
mod described;
#[path = "../../../runtime/tests/machines/device/mod.rs"]
mod device;
mod numbers;

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::cia402::{Edge, Events, HomingBits, Machine, State};

/// The bits of the controlword that commands are made of (CiA 402, controlword, command coding).
const BITS: u16 = 0x008F;

/// What is generated, and what was made by hand; every member of a family is the same machine.
static PAIRS: &[(&str, Machine, Machine)] = &[
    ("C-887", c887::MACHINE, device::c887::MACHINE),
    ("S300", s700::s300::MACHINE, device::s700::MACHINE),
    ("S400", s700::s400::MACHINE, device::s700::MACHINE),
    ("S600", s700::s600::MACHINE, device::s700::MACHINE),
    ("S700", s700::s700::MACHINE, device::s700::MACHINE),
    ("PMC SC6/SI6, double axis", pmc_sc6::double::MACHINE, device::pilz::MACHINE),
    ("PMC SC6/SI6, single axis", pmc_sc6::single::MACHINE, device::pilz::MACHINE),
    ("PMC SC6/SI6, double axis, HiRes", pmc_sc6::double_hires::MACHINE, device::pilz::MACHINE),
    ("PMC SC6/SI6, single axis, HiRes", pmc_sc6::single_hires::MACHINE, device::pilz::MACHINE),
];

/// One member of each family: the others are the same machine.
fn families() -> impl Iterator<Item = &'static (&'static str, Machine, Machine)> {
    PAIRS.iter().filter(|(name, ..)| matches!(*name, "C-887" | "S700" | "PMC SC6/SI6, double axis"))
}

/// Every way in which these bits can change from a word to the next.
fn changes(bits: u16) -> impl Iterator<Item = u16> {
    (0..=bits).filter(move |change| change & !bits == 0)
}

/// Every set of events.
fn events() -> impl Iterator<Item = Events> {
    let all = [
        Events::INITIALISED,
        Events::FAULT,
        Events::FAULT_REACTION_OVER,
        Events::QUICK_STOP_OVER,
        Events::LOCKED_OUT,
        Events::NOT_ENABLED,
    ];
    (0..1_u8 << all.len()).map(move |chosen| {
        let held = all.into_iter().enumerate().filter(move |(bit, _)| chosen >> bit & 1 == 1);
        held.fold(Events::NONE, |set, (_, event)| set | event)
    })
}

#[test]
fn every_statusword_shows_the_same_states() {
    for (name, generated, by_hand) in PAIRS {
        for word in 0..=u16::MAX {
            let states = generated.states.fitting(word);
            assert_eq!(states, by_hand.states.fitting(word), "{name}: {word:04X}");
            assert_eq!(generated.states.decode(word), by_hand.states.decode(word), "{name}: {word:04X}");
        }
    }
}

#[test]
fn every_state_is_shown_alike() {
    for (name, generated, by_hand) in PAIRS {
        for state in State::ALL {
            for word in [0x0000, 0xFFFF] {
                assert_eq!(
                    generated.states.show(state, word),
                    by_hand.states.show(state, word),
                    "{name}: {state}"
                );
            }
        }
    }
}

#[test]
fn members_of_a_family_are_the_same_machine() {
    for (name, generated, by_hand) in PAIRS {
        let mut others = PAIRS.iter().filter(|(.., other)| other == by_hand);
        assert!(others.all(|(_, other, _)| other == generated), "{name}");
    }
}

/// The bits whose change gives a command.
fn edges(machine: &Machine) -> u16 {
    let edges = machine.commands.iter().filter_map(|command| command.edge);
    edges.fold(0, |bits, edge| match edge {
        Edge::Rising(mask) | Edge::Falling(mask) => bits | mask,
    })
}

#[test]
fn every_controlword_makes_the_same_step_after_every_word_that_matters() {
    for (name, generated, by_hand) in families() {
        let edges = edges(generated) | edges(by_hand);
        for state in State::ALL {
            for current in 0..=u16::MAX {
                for change in changes(edges) {
                    let words = (current ^ change, current);
                    let step = generated.step(state, words, Events::NONE);
                    let expected = by_hand.step(state, words, Events::NONE);
                    assert_eq!(step, expected, "{name}: {state}, {words:04X?}");
                }
            }
        }
    }
}

/// Words that differ in the bits of commands only: no command looks at another.
#[test]
fn whatever_happens_every_command_makes_the_same_step() {
    for (name, generated, by_hand) in families() {
        for machine in [generated, by_hand] {
            let looked_at = machine.commands.iter().fold(edges(machine), |bits, one| bits | one.pattern.mask);
            assert_eq!(looked_at, BITS, "{name}");
        }
        for (state, events) in State::ALL.into_iter().flat_map(|state| events().map(move |set| (state, set)))
        {
            for (current, change) in changes(BITS).flat_map(|word| changes(BITS).map(move |to| (word, to))) {
                let words = (current ^ change, current);
                let step = generated.step(state, words, events);
                let expected = by_hand.step(state, words, events);
                assert_eq!(step, expected, "{name}: {state}, {words:04X?}, {events}");
            }
        }
    }
}

#[test]
fn transitions_take_the_same_axes() {
    for (name, generated, by_hand) in PAIRS {
        for number in 0..=u8::MAX {
            assert_eq!(generated.transition(number), by_hand.transition(number), "{name}: {number}");
        }
    }
}

#[test]
fn the_same_modes_are_changed_to_in_the_same_states() {
    for (name, Machine { modes: generated, .. }, Machine { modes: by_hand, .. }) in PAIRS {
        for (from, to) in (i8::MIN..=i8::MAX).flat_map(|from| (i8::MIN..=i8::MAX).map(move |to| (from, to))) {
            assert_eq!(generated.has(from), by_hand.has(from), "{name}: {from}");
            assert_eq!(generated.allows(from, to), by_hand.allows(from, to), "{name}: {from} to {to}");
        }
        for state in State::ALL {
            assert_eq!(
                generated.are_selectable_in(state),
                by_hand.are_selectable_in(state),
                "{name}: {state}"
            );
        }
        assert_eq!(generated.refusal, by_hand.refusal, "{name}");
    }
}

/// C887T0011, p. 15; 1005347, 6.6.9.2; Kollmorgen, 3.4.2 and 3.4.3.
#[test]
fn homing_has_the_bits_of_the_manuals() {
    assert_eq!(c887::HOMING, HomingBits::PROFILE);
    let s700 = HomingBits { start: 1 << 11, reached: 1 << 10, attained: 1 << 9, error: 1 << 13 };
    for bits in [s700::s300::HOMING, s700::s400::HOMING, s700::s600::HOMING, s700::s700::HOMING] {
        assert_eq!(bits, s700);
    }
    use pmc_sc6::{double, double_hires, single, single_hires};
    for bits in [double::HOMING, single::HOMING, double_hires::HOMING, single_hires::HOMING] {
        assert_eq!(bits, HomingBits::PROFILE);
    }
}
