//! The drive state machine against chapter 6.5.

use std::collections::BTreeSet;

use devc::model::{Answer, Event, State, Transition};
use devc_tests::manual::pmc_sc6;

use crate::{departs, device, plain, rows};

fn state(name: &str) -> &'static State {
    let found = device().states.iter().find(|state| plain(&state.name) == plain(name));
    found.unwrap_or_else(|| panic!("there is no state {name}"))
}

fn transition(number: u8) -> &'static Transition {
    let found = device().transitions.iter().find(|transition| transition.number == number);
    found.unwrap_or_else(|| panic!("there is no transition {number}"))
}

#[test]
fn commands_are_those_of_table_5() {
    let rows = rows::<pmc_sc6::Command>();
    assert_eq!(device().commands.len(), rows.len());
    for row in rows {
        let command = device().commands.iter().find(|command| plain(&command.name) == plain(row.name));
        let command = command.unwrap_or_else(|| panic!("there is no command {}", row.name));
        let pattern = command.pattern.as_ref().expect("each command has a pattern");
        let edge = pattern.rising();
        let described = (pattern.mask() & !edge, pattern.value() & !edge, edge);
        assert_eq!(described, (row.pattern.mask, row.pattern.value, row.pattern.rising), "{}", row.name);
    }
}

#[test]
fn transitions_join_the_states_of_the_text() {
    for row in rows::<pmc_sc6::Transition>() {
        let transition = transition(row.transition);
        assert_eq!(*transition.from, [state(row.from).id.as_str()], "transition {}", row.transition);
        assert_eq!(transition.to, state(row.to).id, "transition {}", row.transition);
        assert!(transition.supported);
    }
    let printed: BTreeSet<u8> = rows::<pmc_sc6::Transition>().iter().map(|row| row.transition).collect();
    let other = device().transitions.iter().filter(|transition| !printed.contains(&transition.number));
    let why = "drawn only; assumed to be the profile's";
    departs(other.map(|transition| transition.number), [(0, why), (13, why)]);
}

#[test]
fn transitions_have_the_commands_of_the_text() {
    for row in rows::<pmc_sc6::Transition>().into_iter().filter(|row| !row.command.is_empty()) {
        let commands = device().commands.iter().filter(|it| it.transitions.contains(&row.transition));
        let described: Vec<_> = commands.map(|command| plain(&command.name)).collect();
        assert_eq!(described, [plain(row.command)], "transition {}", row.transition);
    }
}

#[test]
fn transitions_wait_for_the_enable_signal_or_its_loss() {
    for row in rows::<pmc_sc6::Transition>() {
        let transition = transition(row.transition);
        let needed = transition.conditions.iter().any(|text| text.contains("enable signal is active"));
        assert_eq!(needed, row.enable == "active", "transition {}", row.transition);
        let enough = transition.causes.iter().any(|text| text.contains("enable signal is inactive"));
        assert_eq!(enough, row.enable == "inactive", "transition {}", row.transition);
        let lockout = transition.causes.iter().any(|text| text.contains("causes of Switch on disabled"));
        assert_eq!(lockout, row.condition.contains("cause of the lockout"), "transition {}", row.transition);
    }
    assert!(transition(11).causes.iter().any(|text| text.contains("A44 is 1")));
}

/// Transitions 9 and 11 both name the loss of the signal; the latter with A44 = 1, which is what is described.
#[test]
fn the_events_of_transitions_are_what_the_text_names() {
    for row in rows::<pmc_sc6::Transition>() {
        let transition = transition(row.transition);
        let by = |event: Event| transition.events.contains(&event);
        let lost = row.enable == "inactive" && row.transition != 9;
        assert_eq!(by(Event::NotEnabled), lost, "transition {}", row.transition);
        assert_eq!(
            by(Event::LockedOut),
            row.condition.contains("cause of the lockout"),
            "{}",
            row.transition
        );
        let needed = transition.interlocks.contains(&Event::NotEnabled);
        assert_eq!(needed, row.enable == "active", "transition {}", row.transition);
    }
    assert!(transition(12).events.contains(&Event::QuickStopOver));
}

#[test]
fn states_have_the_features_of_the_text() {
    let mut open = Vec::new();
    for row in rows::<pmc_sc6::StateFeatures>() {
        let state = state(row.state);
        let answer = |yes: bool| if yes { Answer::Yes } else { Answer::No };
        for (printed, described) in
            [(row.power_unit, state.high_level_power), (row.drive_function, state.drive_function)]
        {
            if printed.is_some() && described != printed.map(answer) {
                open.push((row.state, printed, described.map(|it| it == Answer::IfRequired)));
            }
        }
        let said = |word: &str| state.features.iter().any(|text| text.contains(word));
        let on = said("power unit is on");
        assert_eq!(on, row.power_unit == Some(true), "{}", row.state);
        assert_eq!(
            said("activation function is enabled"),
            row.activation_function == Some(true),
            "{}",
            row.state
        );
        assert!(said("brakes"), "{}", row.state);
    }
    departs(open, []);
}

#[test]
fn brakes_are_as_the_text_has_them() {
    for row in rows::<pmc_sc6::StateFeatures>() {
        let expected = match row.brake {
            brake if brake.starts_with("engaged") => Answer::Yes,
            "released" => Answer::No,
            _ => Answer::IfRequired,
        };
        assert_eq!(state(row.state).brake, Some(expected), "{}", row.state);
        let release = state(row.state).features.iter().any(|text| text.contains("release override"));
        assert_eq!(release, row.brake.contains("release override"), "{}", row.state);
    }
}

#[test]
fn causes_of_switch_on_disabled_are_those_of_the_text() {
    let described = &state("Switch on disabled").causes;
    let words = ["voltage", "STO", "disable voltage", "quick stop"];
    assert_eq!(described.len(), rows::<pmc_sc6::LockoutCause>().len());
    for ((row, cause), word) in rows::<pmc_sc6::LockoutCause>().iter().zip(described).zip(words) {
        let both = row.cause.to_lowercase().contains(&word.to_lowercase()) && cause.contains(word);
        assert!(both, "cause {}: {cause}, printed {}", row.number, row.cause);
    }
}
