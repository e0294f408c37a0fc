//! Latch words and digital inputs and outputs against chapters 3.7 and 3.12.

use devc::model::{Device, Field};
use devc_tests::manual::{Word, s700};

use crate::{MEMBERS, departs, device, holds_for, rows};

fn field(device: &'static Device, word: &str, bit: u8) -> Option<&'static Field> {
    let word = device.word(word).unwrap_or_else(|| panic!("there is no word {word}"));
    word.fields.iter().find(|field| (field.low..=field.high).contains(&bit))
}

/// The word that a row belongs to.
fn latch_word(word: Word) -> &'static str {
    match word {
        Word::Control => "latch-controlword",
        Word::Status => "latch-statusword",
    }
}

/// The manual's name of a latch in the words of the description: `rise` for an edge, `extern` and `external`.
fn latch(name: &str) -> String {
    let name = name
        .to_lowercase()
        .replace("extern latch", "external latch")
        .replace("intern latch", "internal latch");
    let name =
        name.replace(" (positive rise)", ", positive edge").replace(" (negative rise)", ", negative edge");
    let name = name.trim_start_matches("read ").trim_start_matches("acknowledge value ");
    name.trim_start_matches("status ").to_owned()
}

/// The name that the description has for a row: that of a bit, or of a value of a field.
fn described(device: &'static Device, row: &s700::LatchBits) -> String {
    let value = row.binary.map(|binary| binary.value).unwrap_or_default();
    let bit = if value.is_power_of_two() { u8::try_from(value.trailing_zeros()).ok() } else { None };
    let inputs = row.word == Word::Status && row.first == 12;
    let place = if row.first == row.last || inputs { bit.unwrap_or(row.first) } else { row.first };
    let field = field(device, latch_word(row.word), place).unwrap_or_else(|| panic!("{row:?} is missing"));
    if row.first == row.last || inputs {
        assert_eq!((field.low, field.high), (place, place), "{row:?}");
        return field.name.to_lowercase();
    }
    assert_eq!((field.low, field.high), (row.first, row.last), "{row:?}");
    let value = i64::from(value >> row.first);
    let meaning = field.values.iter().find(|meaning| meaning.value == value);
    meaning.unwrap_or_else(|| panic!("{row:?} is missing")).name.to_lowercase()
}

#[test]
fn latch_words_are_those_of_the_tables() {
    for member in MEMBERS {
        let rows = rows::<s700::LatchBits>().into_iter().filter(|row| row.binary.is_some());
        let both = rows.map(|row| (latch(row.name), described(device(member), &row)));
        let other = both.filter(|(printed, described)| printed != described);
        departs(other, []);
    }
}

#[test]
fn latch_words_have_no_other_bits() {
    for member in MEMBERS {
        for row in rows::<s700::LatchBits>().into_iter().filter(|row| row.name == "Reserve") {
            for bit in row.first..=row.last {
                let field = field(device(member), latch_word(row.word), bit);
                assert!(field.is_some_and(|field| field.reserved), "{row:?}");
            }
        }
        for word in [Word::Control, Word::Status] {
            let values = |row: &s700::LatchBits| row.word == word && row.first == 8;
            let printed = rows::<s700::LatchBits>().iter().filter(|row| values(row)).count();
            let field = field(device(member), latch_word(word), 8).expect("it is described");
            assert_eq!(field.values.len(), printed);
        }
    }
}

#[test]
fn inputs_and_outputs_are_those_of_each_member() {
    for member in MEMBERS {
        for (index, word) in [(0x2302, "digital-outputs"), (0x60FD, "digital-io")] {
            let word = device(member).word(word).expect("it is described");
            assert_eq!(word.address.index.0, index);
            let rows = rows::<s700::IoBit>().into_iter().filter(|row| row.index == index);
            let printed: Vec<_> =
                rows.filter(|row| holds_for(&row.members, member)).map(|row| (row.bit, row.name)).collect();
            let fields = word.fields.iter().filter(|field| !field.reserved);
            // 0x2302 has outputs only, and calls them so.
            let described: Vec<_> = fields
                .map(|field| {
                    (
                        field.low,
                        if index == 0x2302 { field.name.trim_start_matches("digital ") } else { &field.name },
                    )
                })
                .collect();
            assert_eq!(described, printed, "{member:?}");
        }
    }
}
