//! Every statusword after every state.

use devc_runtime::cia402::State::*;
use devc_runtime::cia402::{Machine, Observer, Pattern, State, StatePatterns, StateSet};

use crate::device::{c887, s700};

/// The states of the S700 as printed, where the first two have the same pattern.
const PRINTED: Machine = Machine {
    states: StatePatterns(&[
        (NotReadyToSwitchOn, Pattern { mask: 0x004F, value: 0x0040 }),
        (SwitchOnDisabled, Pattern { mask: 0x004F, value: 0x0040 }),
        (ReadyToSwitchOn, Pattern { mask: 0x004F, value: 0x0001 }),
        (SwitchedOn, Pattern { mask: 0x006F, value: 0x0023 }),
        (OperationEnabled, Pattern { mask: 0x006F, value: 0x0027 }),
        (QuickStopActive, Pattern { mask: 0x006F, value: 0x0003 }),
        (FaultReactionActive, Pattern { mask: 0x006F, value: 0x000F }),
        (Fault, Pattern { mask: 0x006F, value: 0x0028 }),
    ]),
    ..s700::MACHINE
};

#[test]
fn states_that_share_a_pattern_as_the_s700_prints_it_are_told_by_the_one_before() {
    for before in State::ALL {
        for word in 0..=u16::MAX {
            let mut observer = Observer::new(&PRINTED);
            observer.observe(PRINTED.states.show(before, 0)).unwrap();
            let seen = observer.observe(word);
            // 3.4.3: x1xx 0000 is both, and nothing leads back to not ready to switch on
            if word & 0x004F == 0x0040 {
                assert_eq!(seen, Ok(State::SwitchOnDisabled));
                let was_off = matches!(before, State::NotReadyToSwitchOn | State::SwitchOnDisabled);
                let single = observer.possible().single().is_some();
                assert_eq!(single, !was_off, "{before}");
            } else {
                assert_eq!(seen, PRINTED.states.decode(word));
            }
        }
    }
}

#[test]
fn a_device_that_keeps_its_states_apart_is_seen_as_it_is() {
    for before in State::ALL {
        for word in 0..=u16::MAX {
            let mut observer = Observer::new(&c887::MACHINE);
            observer.observe(c887::MACHINE.states.show(before, 0)).unwrap();
            assert_eq!(observer.observe(word).ok(), c887::MACHINE.states.decode(word).ok());
            let shown = c887::MACHINE.states.fitting(word);
            let expected = if shown.is_empty() { StateSet::NONE.with(before) } else { shown };
            assert_eq!(observer.possible(), expected);
        }
    }
}
