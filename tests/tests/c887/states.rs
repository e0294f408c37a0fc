//! The drive state machine and the modes against pages 8 to 17.

use std::collections::BTreeSet;

use devc::model::{Answer, Field, Scope};
use devc_tests::manual::{Axes, Brake, c887};

use crate::{device, plain, rows};

#[test]
fn states_have_the_patterns_of_figure_9() {
    let rows = rows::<c887::State>();
    assert_eq!(device().states.len(), rows.len());
    for row in rows {
        let state = device().states.iter().find(|state| plain(&state.name) == plain(row.name));
        let state = state.unwrap_or_else(|| panic!("there is no state {}", row.name));
        let pattern = state.pattern.as_ref().expect("each state has a pattern");
        assert_eq!((pattern.mask(), pattern.value()), (row.pattern.mask, row.pattern.value), "{}", row.name);
    }
}

#[test]
fn states_have_the_features_of_page_9() {
    let answer = |yes| Some(if yes { Answer::Yes } else { Answer::No });
    for row in rows::<c887::StateFeatures>() {
        let state = device().states.iter().find(|state| plain(&state.name) == plain(row.state));
        let state = state.unwrap_or_else(|| panic!("there is no state {}", row.state));
        let brake = match row.brake {
            Brake::Applied => Answer::Yes,
            Brake::Depends => Answer::IfRequired,
        };
        assert_eq!(state.brake, Some(brake), "{}", row.state);
        assert_eq!(state.low_level_power, answer(row.low_level_power), "{}", row.state);
        assert_eq!(state.high_level_power, answer(row.high_level_power), "{}", row.state);
        assert_eq!(state.drive_function, answer(row.drive_function), "{}", row.state);
        assert_eq!(state.configuration, answer(row.configuration), "{}", row.state);
    }
}

#[test]
fn commands_are_those_of_figure_6() {
    let rows = rows::<c887::Command>();
    assert_eq!(device().commands.len(), rows.len());
    for row in rows {
        let command = device().commands.iter().find(|command| plain(&command.name) == plain(row.name));
        let command = command.unwrap_or_else(|| panic!("there is no command {}", row.name));
        let pattern = command.pattern.as_ref().expect("each command has a pattern");
        let edge = pattern.rising();
        let described = (pattern.mask() & !edge, pattern.value() & !edge, edge);
        assert_eq!(described, (row.pattern.mask, row.pattern.value, row.pattern.rising), "{}", row.name);
        assert_eq!(command.transitions, row.transitions, "{}", row.name);
    }
}

#[test]
fn axes_are_coupled_as_on_page_10() {
    for row in rows::<c887::Transition>() {
        let transition = device().transitions.iter().find(|other| other.number == row.transition);
        let transition = transition.unwrap_or_else(|| panic!("there is no transition {}", row.transition));
        let scope = match row.axes {
            Axes::All => Scope::All,
            Axes::One => Scope::Any,
        };
        assert_eq!(transition.axes, Some(scope), "transition {}", row.transition);
        assert_eq!(transition.power.as_deref(), Some(row.power), "transition {}", row.transition);
        assert!(transition.supported);
    }
    let supported = device().transitions.iter().filter(|transition| transition.supported);
    assert_eq!(
        supported.map(|transition| transition.number).collect::<Vec<_>>(),
        (0..=15).collect::<Vec<_>>()
    );
}

#[test]
fn the_hexapod_state_has_the_values_of_page_9() {
    let entry =
        device().objects.iter().find(|object| object.index.0 == 0x5013).and_then(|object| object.entry(1));
    let described: Vec<_> = entry
        .into_iter()
        .flat_map(|entry| &entry.values)
        .map(|value| (value.value, plain(&value.name)))
        .collect();
    let printed: Vec<_> = rows::<c887::HexapodState>()
        .into_iter()
        .map(|row| (i64::from(row.value), plain(row.state)))
        .collect();
    assert_eq!(described, printed);
}

#[test]
fn modes_are_those_of_the_manual() {
    let printed: Vec<i16> = rows::<c887::Mode>().iter().map(|row| row.code.into()).collect();
    let described: Vec<i16> = device().modes.iter().map(|mode| mode.code).collect();
    assert_eq!(described, printed);
}

#[test]
fn changes_of_mode_are_those_of_page_11() {
    let printed: BTreeSet<(Vec<i16>, Vec<i16>)> = rows::<c887::ModeChange>()
        .iter()
        .map(|row| (vec![row.from.into()], row.to.map(i16::from).into_iter().collect()))
        .collect();
    let described: BTreeSet<_> =
        device().mode_changes.iter().map(|change| (change.from.clone(), change.to.clone())).collect();
    assert_eq!(described, printed);
}

fn field(fields: &[Field], bit: u8) -> Option<&Field> {
    fields.iter().find(|field| (field.low..=field.high).contains(&bit))
}

#[test]
fn control_bits_are_those_of_the_manual() {
    let word = device().word("controlword").expect("it is described");
    for row in rows::<c887::ControlBit>() {
        let mode = row.mode.map(|code| {
            let mode = device().modes.iter().find(|mode| mode.code == i16::from(code));
            &mode.expect("the mode is described").control_bits
        });
        let found = field(mode.unwrap_or(&word.fields), row.bit);
        let reserved = row.name == "reserved";
        match found {
            None => assert!(reserved && row.mode.is_some(), "bit {} in mode {:?}", row.bit, row.mode),
            Some(found) => assert_eq!(found.reserved, reserved, "bit {} in mode {:?}", row.bit, row.mode),
        }
    }
}

#[test]
fn status_bits_are_those_of_the_manual() {
    let word = device().word("statusword").expect("it is described");
    for row in rows::<c887::StatusBit>() {
        let mode = row.mode.map(|code| {
            let mode = device().modes.iter().find(|mode| mode.code == i16::from(code));
            &mode.expect("the mode is described").status_bits
        });
        let found = field(mode.unwrap_or(&word.fields), row.bit);
        let found =
            found.unwrap_or_else(|| panic!("bit {} in mode {:?} is not described", row.bit, row.mode));
        assert_eq!(found.reserved, row.name == "reserved", "bit {} in mode {:?}", row.bit, row.mode);
    }
}
