//! Words and codes against the manual's tables, all 65 536 of them.

use devc_runtime::cia402::State::{self, *};
use devc_runtime::cia402::{Command, Coupling, Pattern, StateSet};
use devc_runtime::error::ErrorCode as _;

use crate::c887::{ErrorCode, STATES, Statusword, TRANSITIONS, commands};

/// Figure 9 as it is printed: bits 6 to 0.
const FIGURE_9: [(State, &str); 8] = [
    (NotReadyToSwitchOn, "0000000"),
    (SwitchOnDisabled, "1000000"),
    (ReadyToSwitchOn, "0100001"),
    (SwitchedOn, "0110011"),
    (OperationEnabled, "0110111"),
    (Fault, "0001000"),
    (FaultReactionActive, "0xx1111"),
    (QuickStopActive, "0010111"),
];

/// Figure 6: bits 7, 3, 2, 1, 0; `^` is a rising edge.
const FIGURE_6: [(Command, &str); 7] = [
    (commands::SHUTDOWN, "0x110"),
    (commands::SWITCH_ON, "00111"),
    (commands::DISABLE_VOLTAGE, "0xx0x"),
    (commands::QUICK_STOP, "0x01x"),
    (commands::DISABLE_OPERATION, "00111"),
    (commands::ENABLE_OPERATION, "01111"),
    (commands::FAULT_RESET, "^xxxx"),
];

/// Whether the bits of the words at these positions are as the row prints them.
fn fits(row: &str, positions: &[u32], previous: u16, current: u16) -> bool {
    let bit = |word: u16, position: &u32| word >> position & 1;
    row.chars().zip(positions).all(|(printed, position)| match printed {
        'x' => true,
        '0' => bit(current, position) == 0,
        '1' => bit(current, position) == 1,
        _ => bit(previous, position) == 0 && bit(current, position) == 1,
    })
}

#[test]
fn every_statusword_shows_the_state_that_the_manual_prints() {
    for word in 0..=u16::MAX {
        let printed: Vec<State> = FIGURE_9
            .iter()
            .filter(|(_, row)| fits(row, &[6, 5, 4, 3, 2, 1, 0], word, word))
            .map(|(state, _)| *state)
            .collect();
        assert!(printed.len() < 2);
        match Statusword(word).state() {
            Ok(state) => assert_eq!(printed, [state]),
            Err(unknown) => {
                assert_eq!(printed, []);
                assert_eq!((unknown.statusword, unknown.candidates), (word, StateSet::NONE));
            }
        }
        assert_eq!(Statusword(word).warning(), word & 0x80 != 0);
    }
}

#[test]
fn every_state_can_be_shown() {
    for state in State::ALL {
        assert_eq!(STATES.decode(STATES.encode(state).unwrap()), Ok(state));
    }
}

#[test]
fn every_controlword_gives_the_commands_that_the_manual_prints() {
    for word in 0..=u16::MAX {
        for previous in [0x0000, 0x0080, 0xFF7F, 0xFFFF, !word] {
            for (command, row) in FIGURE_6 {
                let printed = fits(row, &[7, 3, 2, 1, 0], previous, word);
                assert_eq!(
                    command.is_given(previous, word),
                    printed,
                    "{previous:04X} {word:04X} {}",
                    command.name
                );
            }
        }
    }
}

#[test]
fn a_command_is_given_from_any_word_and_leaves_other_bits() {
    for word in 0..=u16::MAX {
        for command in commands::ALL {
            let (first, second) = (command.prepare(word), command.apply(word));
            assert!(command.is_given(first, second));
            assert_eq!(second & !command.pattern.mask, word & !command.pattern.mask);
            assert_eq!(command.edge.is_some(), !command.is_given(second, second));
        }
    }
}

#[test]
fn transitions_are_those_of_the_manual() {
    let numbers: Vec<u8> = TRANSITIONS.iter().map(|transition| transition.number).collect();
    assert_eq!(numbers, Vec::from_iter(0..=15));
    let by_any = TRANSITIONS.iter().filter(|transition| transition.coupling == Coupling::Any);
    assert_eq!(by_any.map(|transition| transition.number).collect::<Vec<_>>(), Vec::from_iter(5..=13));
    let out_of_quick_stop =
        TRANSITIONS.iter().find(|transition| transition.leads(QuickStopActive, OperationEnabled));
    assert_eq!(out_of_quick_stop, None);
    for command in commands::ALL {
        assert!(command.transitions.iter().all(|number| numbers.contains(number)), "{}", command.name);
    }
}

#[test]
fn error_codes_have_their_own_name_before_that_of_their_range() {
    for (code, printed) in [
        (0x0000, Some("No error")),
        (0x7121, Some("Motor Blocked")),
        (0xFEFF, None),
        (0xFF00, Some("Manufacturer-specific Error Codes")),
        (0xFF50, Some("Safety stop triggered")),
        (0xFF51, Some("Manufacturer-specific Error Codes")),
        (0xFFFE, Some("Manufacturer-specific Error Codes")),
    ] {
        assert_eq!(ErrorCode(code).name(), printed, "0x{code:04X}");
    }
    assert_eq!(ErrorCode::MOTOR_BLOCKED.to_string(), "0x7121: Motor Blocked");
    assert_eq!(ErrorCode(0x1234).to_string(), "0x1234: unknown error");
    assert_eq!(ErrorCode::SAFETY_STOP_TRIGGERED.info().unwrap().vendor_codes, [500, 501, 657]);
}

/// As CiA 402 writes them: x for a bit that does not count.
#[test]
fn patterns_are_shown_as_the_standard_writes_them() {
    let fault = Pattern { mask: 0x004F, value: 0x0008 };
    assert_eq!(fault.to_string(), "xxxx xxxx x0xx 1000");
    assert_eq!(Pattern { mask: 0x8100, value: 0x8100 }.to_string(), "1xxx xxx1 xxxx xxxx");
}
