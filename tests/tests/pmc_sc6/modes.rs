//! Modes of operation, their bits and their motion commands against chapters 6.1, 6.6 and 6.8.

use std::collections::BTreeSet;

use devc::model::{Field, Mode};
use devc_tests::manual::{Edge, Word, pmc_sc6};

use crate::{departs, device, fact, plain, rows};

fn mode(code: i8) -> &'static Mode {
    let found = device().modes.iter().find(|mode| mode.code == i16::from(code));
    found.unwrap_or_else(|| panic!("there is no mode {code}"))
}

fn fields(mode: &'static Mode, word: Word) -> &'static [Field] {
    match word {
        Word::Control => &mode.control_bits,
        Word::Status => &mode.status_bits,
    }
}

#[test]
fn modes_are_those_of_the_manual() {
    let printed: Vec<i16> = rows::<pmc_sc6::Mode>().iter().map(|row| row.code.into()).collect();
    let described: Vec<i16> = device().modes.iter().map(|mode| mode.code).collect();
    assert_eq!(described, printed);
    let default = device().object(devc::model::Index(0x6060)).and_then(|object| object.entry(0));
    let default = default.and_then(|entry| entry.default.as_ref()).map(ToString::to_string);
    assert_eq!(default.as_deref(), Some(fact("mode-default")));
}

#[test]
fn modes_have_the_names_of_the_manual() {
    let name = |name: &str| plain(name).trim_end_matches("mode").to_owned();
    for row in rows::<pmc_sc6::Mode>() {
        assert_eq!(name(&mode(row.code).name), name(row.name), "mode {}", row.code);
    }
    let other = rows::<pmc_sc6::Mode>()
        .into_iter()
        .filter(|row| !row.short.is_empty() && mode(row.code).id != row.short);
    departs(other.map(|row| row.code), [(4, "pt in the manual, tq in the profile; its text says so")]);
}

#[test]
fn controllers_send_set_values_every_cycle() {
    let cyclic = |code: i8| mode(code).conditions.iter().any(|text| text.contains("cyclic"));
    for row in rows::<pmc_sc6::Motion>() {
        assert_eq!(cyclic(row.mode), row.cyclic, "mode {}", row.mode);
    }
    let other = rows::<pmc_sc6::Mode>()
        .into_iter()
        .filter(|row| (row.control == "controller") != mode(row.code).cyclic);
    departs(other.map(|row| row.code), []);
}

#[test]
fn bits_of_modes_are_those_of_the_tables() {
    let places = |word: Word, bits: fn(&Mode) -> &[Field]| -> BTreeSet<_> {
        let bit =
            move |mode: &Mode| -> Vec<_> { bits(mode).iter().map(|field| (mode.code, field.low)).collect() };
        let printed: BTreeSet<_> = rows::<pmc_sc6::ModeBit>()
            .into_iter()
            .filter(|row| row.word == word)
            .map(|row| (i16::from(row.mode), row.bit))
            .collect();
        let described: BTreeSet<_> = device().modes.iter().flat_map(bit).collect();
        described.symmetric_difference(&printed).copied().collect()
    };
    departs(places(Word::Control, |mode| &mode.control_bits), []);
    departs(places(Word::Status, |mode| &mode.status_bits), []);
}

#[test]
fn bits_of_modes_have_names_edges_and_sources() {
    let mut other = Vec::new();
    for row in rows::<pmc_sc6::ModeBit>() {
        let field = fields(mode(row.mode), row.word).iter().find(|field| field.low == row.bit);
        let field = field.unwrap_or_else(|| panic!("{row:?} is missing"));
        let about = field.about.as_deref().unwrap_or_default();
        assert_eq!(field.rising.is_some(), row.edge == Some(Edge::Rising), "{row:?}");
        assert!(
            row.source.is_empty() || about.contains(&format!("source {}", row.source)),
            "{row:?}: {about}"
        );
        if plain(&field.name) != plain(row.name) {
            other.push((row.mode, row.bit, field.name.as_str()));
        }
    }
    departs(other, []);
}

#[test]
fn homing_tells_its_state_by_three_bits() {
    let field = fields(mode(6), Word::Status).iter().find(|field| field.low == 13);
    let about = field.and_then(|field| field.about.as_deref()).expect("bit 13 is described");
    for row in rows::<pmc_sc6::HomingWord>() {
        let bit = |input| match input {
            devc_tests::manual::Input::High => '1',
            _ => '0',
        };
        let word: String = [row.bit13, row.bit12, row.bit10].map(bit).iter().collect();
        assert!(about.contains(&word), "{word}: {}", row.meaning);
    }
}

#[test]
fn motion_commands_are_those_of_table_28() {
    let mut compared = 0;
    for row in rows::<pmc_sc6::Motion>() {
        // Jog is no motion command.
        let Some(code) = row.code else {
            assert!(mode(row.mode).commands.is_empty());
            continue;
        };
        let command = mode(row.mode).commands.iter().find(|command| command.name == row.command);
        let command = command.unwrap_or_else(|| panic!("{row:?} is missing"));
        assert_eq!(command.code, Some(u16::from(code)), "{row:?}");
        let variables = plain(&command.variables.join(""));
        assert_eq!(variables, plain(&row.variables.join("")), "{row:?}");
        assert_eq!(
            plain(command.when.as_deref().unwrap_or_default()),
            plain(&row.settings.replace(" and ", " ")).replace("bits456", "bits45and6"),
            "{row:?}"
        );
        let control = plain(command.control.as_deref().unwrap_or_default());
        let printed = plain(row.control).replace("dependingonselected", "dependsonthe");
        assert_eq!(control, printed, "{row:?}");
        compared += 1;
    }
    assert_eq!(compared, device().modes.iter().map(|mode| mode.commands.len()).sum::<usize>());
}
