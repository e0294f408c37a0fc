//! The drive state machine and the modes of operation against chapters 3.4 and 3.8.

use std::collections::BTreeSet;

use devc::model::{Bit, Device, Field};
use devc_tests::manual::{Edge, Input, s700};

use crate::{departs, family, plain, rows};

/// The facts here are the same on all members.
fn device() -> &'static Device {
    &family().members[0]
}

/// The field of a word at a bit.
fn field(word: &str, bit: u8) -> &'static Field {
    let word = device().word(word).expect("it is described");
    let found = word.fields.iter().find(|field| (field.low..=field.high).contains(&bit));
    found.unwrap_or_else(|| panic!("{} lacks bit {bit}", word.id))
}

#[test]
fn members_have_the_same_state_machine() {
    for other in &family().members {
        assert_eq!(other.states, device().states);
        assert_eq!(other.transitions, device().transitions);
        assert_eq!(other.modes, device().modes);
    }
}

#[test]
fn states_have_the_patterns_of_the_table() {
    let rows = rows::<s700::State>();
    assert_eq!(device().states.len(), rows.len());
    for row in rows {
        // The manual has Disable and Disabled, Enable and Enabled.
        let name = |name: &str| plain(name).trim_end_matches('d').to_owned();
        let state = device().states.iter().find(|state| name(&state.name) == name(row.described));
        let state = state.unwrap_or_else(|| panic!("there is no state {}", row.described));
        let pattern = state.pattern.as_ref().expect("each state has a pattern");
        assert_eq!((pattern.mask(), pattern.value()), (row.pattern.mask, row.pattern.value), "{}", row.name);
    }
}

#[test]
fn transitions_need_the_bits_of_the_table() {
    let rows = rows::<s700::Transition>();
    let numbers: Vec<u8> = device().transitions.iter().map(|transition| transition.number).collect();
    assert_eq!(numbers, rows.iter().map(|row| row.transition).collect::<Vec<_>>());
    for (row, transition) in rows.iter().zip(&device().transitions) {
        let inputs = [(7, row.bit7), (3, row.bit3), (2, row.bit2), (1, row.bit1), (0, row.bit0)];
        for place in 0..16 {
            let bit = transition.pattern.as_ref().and_then(|pattern| pattern.bits.get(place)).copied();
            let input = inputs.iter().find(|(at, _)| *at == place).map_or(Input::Any, |(_, input)| *input);
            let expected = match input {
                Input::Any => Bit::Either,
                Input::Low => Bit::Zero,
                Input::High => Bit::One,
                Input::Rising => Bit::Rising,
                Input::Falling => Bit::Falling,
            };
            let bit = bit.unwrap_or(Bit::Either);
            assert_eq!(bit, expected, "transition {}, bit {place}", row.transition);
        }
        assert!(transition.supported, "transition {}", row.transition);
    }
}

#[test]
fn edges_of_the_controlword_do_what_the_list_says() {
    let word = device().word("controlword").expect("it is described");
    let described: BTreeSet<_> = word
        .fields
        .iter()
        .flat_map(|field| {
            let rising = field.rising.as_ref().map(|_| (field.low, Edge::Rising));
            [rising, field.falling.as_ref().map(|_| (field.low, Edge::Falling))]
        })
        .flatten()
        .collect();
    let printed = rows::<s700::ControlEdge>().iter().map(|row| (row.bit, row.edge)).collect();
    assert_eq!(described, printed);
}

#[test]
fn edges_name_the_commands_of_the_list() {
    let commands = ["DECSTOP", "DECDIS", "OPMODE", "SERCSET", "F29", "0x2355"];
    for row in rows::<s700::ControlEdge>() {
        let field = field("controlword", row.bit);
        let text = match row.edge {
            Edge::Rising => field.rising.as_deref(),
            Edge::Falling => field.falling.as_deref(),
        };
        let text = text.unwrap_or_default();
        assert!(text.contains(row.ascii), "{row:?}: {text}");
        for command in commands.into_iter().filter(|command| row.meaning.contains(command)) {
            assert!(text.contains(command), "{row:?}: {command} is not in {text:?}");
        }
    }
}

#[test]
fn bits_of_the_controlword_are_those_with_an_edge() {
    let edges: BTreeSet<u8> = rows::<s700::ControlEdge>().iter().map(|row| row.bit).collect();
    for bit in 0..16 {
        let field = field("controlword", bit);
        assert_eq!(field.reserved, !edges.contains(&bit), "bit {bit}");
        assert!(!field.per_mode, "bit {bit} means the same in all modes");
    }
    assert!(rows::<s700::ControlBit>().iter().all(|row| edges.contains(&row.bit)));
}

#[test]
fn bits_of_the_controlword_have_their_names() {
    let other = rows::<s700::ControlBit>().into_iter().filter_map(|row| {
        let name = field("controlword", row.bit).name.as_str();
        (plain(name) != plain(row.name)).then_some((row.name, name))
    });
    departs(other, []);
}

#[test]
fn bits_of_the_statusword_are_those_of_the_table() {
    let printed: BTreeSet<u8> = rows::<s700::StatusBit>().iter().map(|row| row.bit).collect();
    for bit in 0..16 {
        let field = field("statusword", bit);
        assert_eq!(field.reserved, !printed.contains(&bit), "bit {bit}");
        assert!(!field.per_mode, "bit {bit} means the same in all modes");
    }
    for row in rows::<s700::StatusBit>().into_iter().filter(|row| row.note.starts_with("OPMODE")) {
        let about = field("statusword", row.bit).about.as_deref().unwrap_or_default();
        assert!(about.contains(row.note), "bit {}: {about}", row.bit);
    }
}

#[test]
fn bits_of_the_statusword_have_their_names() {
    let other = rows::<s700::StatusBit>().into_iter().filter_map(|row| {
        let name = field("statusword", row.bit).name.as_str();
        (!plain(row.name).starts_with(&plain(name))).then_some((row.bit, name))
    });
    departs(other, [((14, "hardware reset needed"), "printed as a sentence")]);
}

#[test]
fn modes_have_both_codes() {
    let printed: BTreeSet<_> = rows::<s700::Mode>()
        .into_iter()
        .map(|row| (plain(row.name), i16::from(row.code), vec![i16::from(row.vendor.cast_signed())]))
        .collect();
    let described: BTreeSet<_> =
        device().modes.iter().map(|mode| (plain(&mode.name), mode.code, mode.aliases.clone())).collect();
    assert_eq!(described, printed);
}

/// The bits of a reference run stand among those of both words; the manual names them without a mode.
#[test]
fn homing_uses_the_bits_that_the_tables_name() {
    let mode = device().modes.iter().find(|mode| mode.code == 6).expect("homing is described");
    let bits = mode.homing_bits.expect("homing has bits");
    let edges = rows::<s700::ControlEdge>();
    let start = edges.iter().find(|row| row.edge == Edge::Rising && row.meaning.contains("reference run"));
    assert_eq!(Some(bits.start), start.map(|row| row.bit));
    let named = |name: &str| {
        rows::<s700::StatusBit>().iter().find(|row| row.name.to_lowercase().contains(name)).map(|row| row.bit)
    };
    assert_eq!(Some(bits.reached), named("target reached"));
    assert_eq!(Some(bits.attained), named("reference point set"));
    assert_eq!(Some(bits.error), named("homing error"));
}
