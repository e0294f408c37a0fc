//! The tables of the PMC SC6 and SI6 against the sums that their manual allows, and against each other.

use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::manual::rows;

/// Reads a table that has to be readable.
fn table<R: Row>() -> Vec<R> {
    rows().unwrap()
}

/// How many entries a row stands for.
fn entries(sub: Sub) -> usize {
    match sub {
        Sub::Variable => 0,
        Sub::One(_) => 1,
        Sub::Range(first, last) => usize::from(last - first) + 1,
    }
}

/// The rows of an axis.
fn axis(number: u8) -> Vec<Object> {
    table::<Object>().into_iter().filter(|row| row.table == number).collect()
}

#[test]
fn dictionary_has_242_entries_of_132_objects() {
    let rows = table::<Object>();
    assert_eq!(rows.iter().map(|row| row.index).collect::<BTreeSet<_>>().len(), 132);
    assert_eq!(rows.iter().map(|row| entries(row.sub)).sum::<usize>(), 242);
    assert_eq!(rows.len(), 240);
}

#[test]
fn dictionary_ascends() {
    for pair in table::<Object>().windows(2) {
        let [low, high] = pair else { continue };
        assert!((low.index, low.sub) < (high.index, high.sub), "{low:?} before {high:?}");
    }
}

#[test]
fn axis_b_is_axis_a_shifted_but_in_five_rows() {
    let (first, second) = (axis(34), axis(35));
    assert_eq!(first.len(), second.len());
    let mut different = Vec::new();
    for (row, expected) in second.iter().zip(&first) {
        assert_eq!((row.index, row.sub), (expected.index + 0x800, expected.sub));
        let shifted = Object { table: row.table, index: row.index, ..expected.clone() };
        if *row != shifted {
            different.push((row.index, row.sub));
        }
        assert_eq!((row.tx, row.rx), (expected.tx, expected.rx), "{row:?}");
        assert_eq!((row.parameter, row.note), (expected.parameter, expected.note), "{row:?}");
    }
    // A wrong name, a longer name, and three records that are arrays.
    let expected = [
        (0x687B, Sub::Variable),
        (0x68A4, Sub::One(1)),
        (0x68C1, Sub::Variable),
        (0x68C2, Sub::Variable),
        (0x68C4, Sub::Variable),
    ];
    assert_eq!(different, expected);
}

#[test]
fn heads_have_no_ticks_and_entries_have_both() {
    for row in table::<Object>() {
        let head = row.sub == Sub::Variable;
        assert_eq!((row.tx.is_none(), row.rx.is_none()), (head, head), "{row:?}");
        assert_eq!(row.elements.is_some(), head, "{row:?}");
        assert!(!head || ["Array", "Record", "Structure"].contains(&row.shape), "{row:?}");
    }
}

#[test]
fn counts_agree_with_what_follows_but_in_two_objects_of_each_axis() {
    let mut wrong = Vec::new();
    let rows = table::<Object>();
    for head in rows.iter().filter(|row| row.sub == Sub::Variable) {
        let of = rows.iter().filter(|row| row.index == head.index);
        let constant = of.clone().find_map(|row| row.constant).unwrap();
        let members = of.map(|row| entries(row.sub)).sum::<usize>() - 1;
        if [head.elements, Some(constant)] != [u8::try_from(members).ok(); 2] {
            wrong.push((head.index, head.elements, constant, members));
        }
    }
    let expected =
        [(0x60C4, Some(5), 5, 6), (0x60D0, Some(3), 2, 2), (0x68C4, Some(5), 5, 6), (0x68D0, Some(3), 2, 2)];
    assert_eq!(wrong, expected);
}

#[test]
fn every_entry_has_a_parameter_or_a_constant_but_the_supported_modes() {
    let rows = table::<Object>();
    let bare: Vec<_> = rows
        .iter()
        .filter(|row| row.sub != Sub::Variable && row.parameter.is_empty() && row.constant.is_none())
        .map(|row| row.index)
        .collect();
    assert_eq!(bare, [0x6502, 0x6D02]);
}

/// The bytes of each PDO by its table.
fn sizes() -> BTreeMap<u8, u8> {
    table::<Mapped>().iter().map(|row| (row.table, row.last + 1)).collect()
}

#[test]
fn pdos_are_23_and_29_bytes_or_7_or_5() {
    let sizes: Vec<_> = sizes().into_iter().collect();
    let expected = [
        (8, 7),
        (9, 7),
        (10, 7),
        (11, 7),
        (18, 5),
        (19, 5),
        (20, 5),
        (21, 5),
        (30, 23),
        (31, 23),
        (32, 29),
        (33, 29),
    ];
    assert_eq!(sizes, expected);
}

#[test]
fn bytes_follow_each_other_and_fit_the_type() {
    let mut next = BTreeMap::<_, u8>::new();
    for row in table::<Mapped>() {
        let place = next.entry(row.table).or_default();
        assert_eq!(row.first, *place, "{row:?}");
        *place = row.last + 1;
        let bytes = match row.data_type {
            "INT8" => 1,
            // `INT` is no type of table 2.
            "INT16" | "INT" | "WORD" => 2,
            "INT32" | "DWORD" => 4,
            other => panic!("{other}"),
        };
        assert_eq!(row.last + 1 - row.first, bytes, "{row:?}");
    }
}

#[test]
fn pdos_of_axis_b_are_those_of_axis_a_shifted() {
    let rows = table::<Mapped>();
    let of = |axis| rows.iter().filter(move |row| row.axis == axis);
    assert_eq!(of(AxisLetter::A).count(), 30);
    for (first, second) in of(AxisLetter::A).zip(of(AxisLetter::B)) {
        let shifted = Mapped {
            table: first.table + 1,
            axis: AxisLetter::B,
            parameter: second.parameter,
            object: first.object.map(|index| index + 0x800),
            ..first.clone()
        };
        assert_eq!(*second, shifted);
        assert_eq!(first.parameter.strip_prefix("1."), second.parameter.strip_prefix("2."));
    }
}

#[test]
fn mapped_objects_exist_but_the_digital_outputs() {
    let objects = table::<Object>();
    let mut missing = BTreeSet::new();
    for row in table::<Mapped>() {
        let Some(index) = row.object else { continue };
        let parameter = &row.parameter[2..];
        match objects.iter().find(|object| object.index == index && object.parameter == parameter) {
            Some(object) => {
                let mappable = if row.direction == Direction::Rx { object.rx } else { object.tx };
                assert_eq!(mappable, Some(true), "{row:?}");
            }
            None => _ = missing.insert((index, parameter)),
        }
    }
    assert_eq!(missing, BTreeSet::from([(0x60FE, "A637"), (0x68FE, "A637")]));
}

#[test]
fn groups_follow_the_formula_but_three() {
    let groups = table::<Group>();
    assert_eq!(groups.len(), 38);
    let mut wrong = Vec::new();
    for group in &groups {
        let base = if group.axis == AxisLetter::A { 0x2000 } else { 0xA000 };
        assert_eq!(group.last - group.first, 511, "{group:?}");
        assert_eq!(group.lowest, format!("{}00", group.letter));
        assert_eq!(group.highest, format!("{}511", group.letter));
        if group.first != base + group.number * 512 {
            wrong.push((group.axis, group.letter, group.first));
        }
    }
    let expected = [(AxisLetter::A, "M", 0x3600), (AxisLetter::B, "M", 0xB600), (AxisLetter::B, "Z", 0xD000)];
    assert_eq!(wrong, expected);
}

#[test]
fn numbers_of_groups_are_places_in_the_alphabet() {
    for group in table::<Group>() {
        let letter = group.letter.bytes().next().unwrap();
        assert_eq!(u16::from(letter - b'A'), group.number, "{group:?}");
    }
    let topics: BTreeSet<_> = table::<GroupTopic>().iter().map(|topic| topic.letter).collect();
    let numbered: BTreeSet<_> = table::<Group>().iter().map(|group| group.letter).collect();
    assert_eq!(topics.difference(&numbered).copied().collect::<Vec<_>>(), ["L", "N"]);
    assert!(numbered.is_subset(&topics));
}

#[test]
fn examples_of_coordinates_follow_the_formula() {
    let examples = table::<Coordinate>();
    assert_eq!(examples.len(), 2);
    for row in examples {
        assert_eq!(row.index, row.base + row.group * row.factor + row.line, "{row:?}");
        assert_eq!(row.sdo_info, row.rx + 1);
    }
}

#[test]
fn commands_are_the_profiles_seven() {
    let commands = table::<Command>();
    assert_eq!(commands.len(), 7);
    assert_eq!(commands.last().map(|command| command.pattern.rising), Some(0x80));
    assert!(commands.iter().all(|command| command.pattern.mask & 0x70 == 0), "bits 4 to 6 are free");
}

#[test]
fn transitions_join_the_eight_states() {
    let states: BTreeSet<_> = table::<StateFeatures>().iter().map(|row| row.state).collect();
    assert_eq!(states.len(), 8);
    let transitions = table::<Transition>();
    assert!(transitions.iter().all(|row| states.contains(row.from) && states.contains(row.to)));
    let mut numbers: Vec<_> = transitions.iter().map(|row| row.transition).collect();
    numbers.sort_unstable();
    assert_eq!(numbers, [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 15]);
    let commands: BTreeSet<_> = table::<Command>().iter().map(|command| command.name).collect();
    assert!(transitions.iter().all(|row| row.command.is_empty() || commands.contains(row.command)));
}

#[test]
fn modes_are_eleven_and_each_has_its_motion() {
    let modes: BTreeSet<_> = table::<Mode>().iter().map(|mode| mode.code).collect();
    assert_eq!(modes, BTreeSet::from([-1, 0, 1, 2, 3, 4, 6, 7, 8, 9, 10]));
    assert_eq!(table::<Motion>().len(), 13);
    assert_eq!(table::<Motion>().iter().map(|motion| motion.mode).collect::<BTreeSet<_>>(), modes);
    let bits = table::<ModeBit>();
    assert_eq!(bits.len(), 25);
    assert!(bits.iter().all(|bit| modes.contains(&bit.mode)));
}

#[test]
fn mode_bits_lie_where_the_profile_leaves_room() {
    for bit in table::<ModeBit>() {
        match bit.word {
            Word::Control => assert!([4, 5, 6].contains(&bit.bit) && bit.source.is_empty(), "{bit:?}"),
            Word::Status => assert!([10, 12, 13].contains(&bit.bit) && !bit.source.is_empty(), "{bit:?}"),
        }
    }
    assert_eq!(table::<HomingWord>().len(), 6);
}

#[test]
fn homing_methods_are_19_with_20_codes() {
    let methods = table::<Homing>();
    assert!(
        methods.iter().map(|row| row.method).eq("ABCDEFGHIJKLMNOPQRS".split("").filter(|s| !s.is_empty()))
    );
    let codes: BTreeSet<_> = methods.iter().flat_map(|row| row.codes.clone()).collect();
    assert_eq!(codes.len(), 20);
    for row in methods {
        // The search for the zero pulse starts at I53, except where it is all there is.
        let index = row.prepared.contains(&"I53");
        assert_eq!(index, row.zero_pulse && !["M", "N"].contains(&row.method), "{row:?}");
        assert_eq!(row.zero_pulse, row.name.contains("index pulse"), "{row:?}");
    }
}

#[test]
fn limit_switch_has_seven_causes_and_a_denial_six() {
    let causes = table::<Cause>();
    let of = |place| causes.iter().filter(|row| row.place == place).map(|row| row.code).collect::<Vec<_>>();
    assert_eq!(of("event 53"), [1, 2, 3, 4, 5, 6, 7]);
    assert_eq!(of("I90"), [1, 2, 3, 10, 11, 12]);
    assert_eq!(of("E80"), [15, 20]);
}

#[test]
fn pdo_timeouts_leave_one_value_open() {
    let mut next = 0_u32;
    let mut open = Vec::new();
    for row in table::<PdoTimeout>() {
        open.extend(next..u32::from(row.first));
        next = u32::from(row.last) + 1;
    }
    assert_eq!((open, next), (vec![65534], 0x1_0000));
}

#[test]
fn data_types_hold_their_ranges() {
    let types = table::<DataType>();
    assert_eq!(types.len(), 11);
    for row in types.iter().filter(|row| row.name.starts_with("INT")) {
        let half = 1_i64 << (row.bits - 1);
        assert_eq!((row.min.parse(), row.max.parse()), (Ok(-half), Ok(half - 1)), "{row:?}");
    }
    for row in types.iter().filter(|row| row.signed == Some(false)) {
        assert_eq!(row.max.parse(), Ok((1_u64 << row.bits) - 1), "{row:?}");
    }
}

#[test]
fn mapping_parameters_hold_24_entries() {
    let parameters = table::<MappingParameter>();
    assert_eq!(parameters.len(), 4);
    assert!(parameters.iter().all(|row| row.last + 1 - row.first == 24));
}

#[test]
fn other_tables_are_whole() {
    assert_eq!(table::<CycleTime>().len(), 12);
    assert_eq!(table::<LimitCondition>().len(), 6);
    assert_eq!(table::<LockoutCause>().len(), 4);
    assert_eq!(table::<StartupTransition>().len(), 5);
    assert_eq!(table::<TouchProbeBit>().len(), 7);
    let names: BTreeSet<_> = table::<Parameter>().iter().map(|row| row.parameter).collect();
    assert_eq!(names.len(), table::<Parameter>().len(), "a parameter stands twice");
    let keys: BTreeSet<_> = table::<Fact>().iter().map(|fact| fact.key).collect();
    assert_eq!(keys.len(), table::<Fact>().len(), "a key stands twice");
}
