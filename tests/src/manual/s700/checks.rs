//! The tables of the S700 against the sums that its manual allows, and against each other.

use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::manual::{Cell, rows};

/// Reads a table that has to be readable.
fn table<R: Row>() -> Vec<R> {
    rows().unwrap()
}

/// The facts by their keys.
fn facts() -> BTreeMap<&'static str, &'static str> {
    table::<Fact>().into_iter().map(|fact| (fact.key, fact.value)).collect()
}

#[test]
fn setpoints_are_30_objects_and_actual_values_43() {
    let rows = table::<Object>();
    let of = |direction| rows.iter().filter(move |row| row.direction == direction);
    assert_eq!([of(Direction::Rx).count(), of(Direction::Tx).count()], [30, 43]);
    assert_eq!(of(Direction::Rx).next_back().map(|row| row.row), Some(30));
    // 0x6062 and 0x60FC share a row.
    assert_eq!(of(Direction::Tx).next_back().map(|row| row.row), Some(42));
}

#[test]
fn objects_ascend_within_a_direction_but_for_the_row_of_two() {
    for pair in table::<Object>().windows(2) {
        let [low, high] = pair else { continue };
        let ascends = (low.direction, low.index, low.sub) < (high.direction, high.index, high.sub);
        assert!(ascends || low.index == 0x60FC, "{low:?} before {high:?}");
    }
}

#[test]
fn objects_have_three_types_and_one_index_is_in_both_directions() {
    let rows = table::<Object>();
    let types: BTreeSet<_> = rows.iter().map(|row| row.data_type).collect();
    assert_eq!(types, BTreeSet::from(["INT16", "INT32", "UINT16"]));
    let indices = |direction| -> BTreeSet<_> {
        rows.iter().filter(|row| row.direction == direction).map(|row| row.index).collect()
    };
    let both: Vec<_> = indices(Direction::Rx).intersection(&indices(Direction::Tx)).copied().collect();
    assert_eq!(both, [0x2355]);
}

#[test]
fn twelve_rows_print_no_subindex() {
    let rows = table::<Object>();
    let missing: Vec<_> = rows.iter().filter(|row| row.sub == Sub::Variable).map(|row| row.index).collect();
    let expected =
        [0x2308, 0x2355, 0x2050, 0x20A0, 0x20A5, 0x2353, 0x2355, 0x3612, 0x6041, 0x6063, 0x6077, 0x60F4];
    assert_eq!(missing, expected);
}

#[test]
fn fixed_pdos_are_13_to_receive_and_10_to_transmit() {
    let pdos = table::<Pdo>();
    let count = |direction| pdos.iter().filter(|pdo| pdo.direction == direction).count();
    assert_eq!([count(Direction::Rx), count(Direction::Tx)], [13, 10]);
    for pdo in &pdos {
        let high = if pdo.direction == Direction::Rx { 0x17 } else { 0x1B };
        assert_eq!(pdo.pdo >> 8, high, "{pdo:?}");
    }
}

#[test]
fn entries_number_118_and_add_up_but_in_two_pdos() {
    let entries = table::<Entry>();
    assert_eq!(entries.len(), 118);
    let mut wrong = Vec::new();
    for pdo in table::<Pdo>() {
        let own: Vec<_> = entries.iter().filter(|entry| entry.pdo == pdo.pdo).collect();
        assert!(own.iter().map(|entry| entry.position).eq(1..=u8::try_from(own.len()).unwrap()));
        let sum: u8 = own.iter().map(|entry| entry.bytes).sum();
        if sum != pdo.total {
            wrong.push((pdo.pdo, pdo.total, sum));
        }
    }
    assert_eq!(wrong, [(0x170A, 10, 8), (0x1B0A, 8, 10)]);
}

#[test]
fn interfaces_pair_the_pdos() {
    let interfaces = table::<Interface>();
    assert!(interfaces.iter().map(|interface| interface.item).eq(1..=13));
    let used: BTreeSet<_> = interfaces.iter().flat_map(|interface| [interface.rx, interface.tx]).collect();
    assert_eq!(used, table::<Pdo>().iter().map(|pdo| pdo.pdo).collect());
    for pdo in table::<Pdo>() {
        let has = |of: &&Interface| of.rx == pdo.pdo || of.tx == pdo.pdo && !of.example;
        assert!(interfaces.iter().filter(has).map(|of| of.item).eq(pdo.items.iter().copied()), "{pdo:?}");
        assert!(interfaces.iter().filter(has).all(|of| of.members == pdo.members), "{pdo:?}");
    }
}

#[test]
fn long_pdos_are_those_of_the_extended_mapping() {
    let facts = facts();
    let limit: u8 = facts["extended-mapping-above-bytes"].parse().unwrap();
    for pdo in table::<Pdo>().iter().filter(|pdo| pdo.total > limit) {
        assert_eq!(pdo.members, [Member::S300, Member::S700]);
    }
}

#[test]
fn defaults_cover_the_family_once() {
    let mut members: Vec<_> = table::<Pdo>().into_iter().flat_map(|pdo| pdo.default).collect();
    members.sort_unstable();
    assert_eq!(members, [Member::S300, Member::S400, Member::S600, Member::S700]);
}

#[test]
fn registers_are_18_that_do_not_overlap() {
    let registers = table::<Register>();
    assert_eq!(registers.len(), 18);
    for pair in registers.windows(2) {
        let [low, high] = pair else { continue };
        assert!(low.address + low.length <= high.address, "{low:?} and {high:?}");
    }
}

#[test]
fn bits_stand_at_their_register_but_in_two_rows() {
    let bits = table::<RegisterBits>();
    assert_eq!(bits.len(), 29);
    let astray: Vec<_> = bits
        .iter()
        .filter(|row| !(row.register..row.register + 3).contains(&row.address))
        .map(|row| (row.name, row.address))
        .collect();
    assert_eq!(astray, [("Sync Manager 2 Event", 0x0201), ("Sync Manager 3 Event", 0x0201)]);
    let registers: BTreeSet<_> = table::<Register>().iter().map(|row| row.address).collect();
    assert!(bits.iter().all(|row| registers.contains(&row.register) && row.first <= row.last));
}

#[test]
fn states_of_the_esm_are_five_in_both_registers() {
    for register in [0x0120, 0x0130] {
        let of: Vec<_> = table::<AlState>().into_iter().filter(|row| row.register == register).collect();
        assert!(of.iter().map(|row| row.value).eq([1, 2, 3, 4, 8]));
    }
    assert_eq!(table::<AlCode>().iter().map(|row| row.code).collect::<Vec<_>>(), [0, 0x11, 0x17, 0x1A]);
}

#[test]
fn transitions_of_the_esm_ask_for_the_state_they_enter() {
    let transitions = table::<EsmTransition>();
    assert_eq!(transitions.len(), 11);
    for row in transitions {
        let expected = match row.transition.chars().last() {
            Some('B') => Some(3),
            Some('I') if row.transition == "BI" => None,
            Some('I') => Some(1),
            Some('P') => Some(2),
            Some('S') => Some(4),
            Some('O') => Some(8),
            other => panic!("{other:?}"),
        };
        assert_eq!(row.al, expected, "{row:?}");
    }
}

#[test]
fn transitions_are_0_to_16_and_twelve_need_an_edge() {
    let transitions = table::<Transition>();
    assert!(transitions.iter().map(|row| row.transition).eq(0..=16));
    let edges = |row: &&Transition| {
        [row.bit7, row.bit3, row.bit2, row.bit1, row.bit0]
            .iter()
            .any(|input| matches!(input, Input::Rising | Input::Falling))
    };
    let with: Vec<_> = transitions.iter().filter(edges).map(|row| row.transition).collect();
    assert_eq!(with, [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 16]);
}

#[test]
fn patterns_of_eight_states_clash_where_the_manual_repeats_itself() {
    let states = table::<State>();
    assert_eq!(states.len(), 8);
    let mut clashes = Vec::new();
    for (place, state) in states.iter().enumerate() {
        for other in &states[place + 1..] {
            if state.pattern.overlaps(other.pattern) {
                clashes.push((state.name, other.name));
            }
        }
    }
    assert_eq!(clashes, [("Not Ready to Switch On", "Switch On Disabled")]);
}

#[test]
fn edges_of_the_control_word_come_in_pairs() {
    let edges = table::<ControlEdge>();
    for edge in [Edge::Rising, Edge::Falling] {
        let bits = edges.iter().filter(|row| row.edge == edge).map(|row| row.bit);
        assert!(bits.eq([0, 1, 2, 3, 7, 11, 12, 15]), "{edge:?}");
    }
    assert!(table::<ControlBit>().iter().map(|row| row.bit).eq([0, 1, 2, 3, 7]));
}

#[test]
fn status_word_lacks_bit_4() {
    let bits = table::<StatusBit>();
    assert!(bits.iter().map(|row| row.bit).eq((0..16).filter(|bit| *bit != 4)));
}

#[test]
fn latch_words_are_whole_and_both_notations_agree() {
    let rows = table::<LatchBits>();
    for word in [Word::Control, Word::Status] {
        let bits: BTreeSet<_> =
            rows.iter().filter(|row| row.word == word).flat_map(|row| row.first..=row.last).collect();
        assert_eq!(bits, (0..16).collect());
    }
    for row in rows.iter().filter(|row| !row.hex.is_empty()) {
        let binary = row.binary.unwrap();
        let hex = u16::from_str_radix(&row.hex.replace('x', "0"), 16).unwrap();
        assert_eq!(binary.value, hex, "{row:?}");
        assert!(hex >> row.first != 0 && u32::from(hex) < 1 << (row.last + 1), "{row:?}");
    }
}

#[test]
fn modes_are_four_whose_second_code_is_negative() {
    let modes = table::<Mode>();
    assert_eq!(modes.iter().map(|mode| mode.code).collect::<BTreeSet<_>>(), BTreeSet::from([6, 8, 9, 10]));
    assert!(modes.iter().all(|mode| mode.vendor.cast_signed() < 0));
}

#[test]
fn cycles_are_multiples_of_the_increment() {
    let increment: u16 = facts()["cycle-increment-us"].parse().unwrap();
    assert_eq!(table::<CycleTime>().len(), 6);
    assert!(table::<CycleTime>().iter().all(|row| row.min_us % increment == 0));
    assert!(table::<SlowCycle>().iter().all(|row| row.cycle_us % increment == 0));
}

#[test]
fn startup_list_has_17_rows_and_data_that_agree_with_the_decimals() {
    let rows = table::<Startup>();
    assert_eq!(rows.len(), 17);
    assert_eq!(rows.iter().filter(|row| row.generated).count(), 14);
    for row in &rows {
        let value = row.value.to_string();
        match row.decimal.strip_suffix("...") {
            Some(start) => assert!(value.starts_with(start), "{row:?}"),
            None => assert_eq!(value, row.decimal, "{row:?}"),
        }
    }
    let misprints = rows.iter().filter(|row| u16::parse(row.printed) != Ok(row.index)).count();
    assert_eq!(misprints, 8);
    let data: Vec<_> = rows.iter().filter(|row| u32::parse(row.data) != Ok(row.value)).collect();
    assert!(data.iter().map(|row| (row.data, row.value)).eq([("0xA00", 0x1A00)]));
}

#[test]
fn startup_maps_objects_that_the_tables_have_with_their_sizes() {
    let objects = table::<Object>();
    for row in table::<Startup>() {
        if ![0x1600, 0x1A00].contains(&row.index) || row.sub == 0 {
            continue;
        }
        let bits = row.value & 0xFF;
        let object = objects.iter().find(|object| u32::from(object.index) == row.value >> 16).unwrap();
        assert!(object.data_type.ends_with(&bits.to_string()), "{row:?}");
    }
}

#[test]
fn mailbox_example_writes_0x1704_to_0x1c12() {
    let bytes = |telegram| -> Vec<_> {
        table::<MailboxByte>().iter().filter(|row| row.telegram == telegram).map(|row| row.value).collect()
    };
    let request = bytes("request");
    assert_eq!(request.len(), 16);
    assert_eq!(request[..8], [0x0A, 0, 0, 0, 0, 3, 0, 0x20]);
    assert_eq!(request[8..], [0x2B, 0x12, 0x1C, 1, 0x04, 0x17, 0, 0]);
    let answer = bytes("answer");
    assert_eq!(answer.len(), 16);
    assert_eq!(answer[..8], [0x0E, 0, 0, 0, 0, 3, 0, 0x20]);
    assert_eq!(answer[8..], [0x60, 0x12, 0x1C, 1, 0, 0, 0, 0]);
}

#[test]
fn telegrams_have_16_bytes() {
    for mailbox in ["output", "input"] {
        let bytes: BTreeSet<_> = table::<TelegramField>()
            .iter()
            .filter(|row| row.mailbox == mailbox)
            .map(|row| row.byte)
            .collect();
        assert_eq!(bytes, (0..16).collect());
    }
}

#[test]
fn other_tables_are_whole() {
    assert_eq!(table::<Led>().len(), 15);
    assert_eq!(table::<MappingStep>().len(), 9);
    assert_eq!(table::<IoBit>().len(), 11);
    assert_eq!(table::<TelegramValue>().len(), 33);
    assert_eq!(facts().len(), table::<Fact>().len(), "a key stands twice");
}
