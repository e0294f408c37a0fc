//! The object dictionary against the appendix.

use std::collections::{BTreeMap, BTreeSet};

use devc::model::{Access, Address, Entry, Index, Object, Value, WriteWindow};
use devc_tests::manual::{self, Sub, c887};

use crate::{departs, device, rows};

/// The rows that name a single entry; two rows name all entries of an object, `1C32:01:32` and `1C33:01:32`.
fn entry_rows() -> impl Iterator<Item = (c887::Object, Address)> {
    rows::<c887::Object>().into_iter().filter_map(|row| {
        let subindex = match row.sub {
            Sub::Variable => 0,
            Sub::One(subindex) => subindex,
            Sub::Range(..) => return None,
        };
        let address = Address { index: Index(row.index), subindex };
        Some((row, address))
    })
}

fn entry(address: Address) -> &'static Entry {
    device().entry(address).unwrap_or_else(|| panic!("the description lacks {address}"))
}

fn object(index: u16) -> &'static Object {
    device().object(Index(index)).unwrap_or_else(|| panic!("the description lacks 0x{index:04X}"))
}

#[test]
fn objects_are_those_of_the_manual() {
    let printed: BTreeSet<u16> = rows::<c887::Object>().iter().map(|row| row.index).collect();
    let described: BTreeSet<u16> = device().objects.iter().map(|object| object.index.0).collect();
    assert_eq!(described, printed);
    assert_eq!(described.len(), 148);
}

#[test]
fn entries_are_those_of_the_manual() {
    let printed: BTreeSet<Address> = entry_rows().map(|(_, address)| address).collect();
    assert_eq!(printed.len(), 339 - 2);
    let described: BTreeSet<Address> = device()
        .objects
        .iter()
        .filter(|object| !matches!(object.index.0, 0x1C32 | 0x1C33))
        .flat_map(|object| object.entries.iter().map(|entry| entry.address))
        .collect();
    assert_eq!(described, printed);
}

#[test]
fn each_axis_has_twenty_three_entries() {
    let mut count: BTreeMap<Option<u8>, usize> = BTreeMap::new();
    let profile = device().objects.iter().filter(|object| object.index.0 >= 0x6000);
    for object in profile {
        *count.entry(object.axis).or_default() += object.entries.len();
    }
    let expected: BTreeMap<Option<u8>, usize> = (0..6).map(|axis| (Some(axis), 23)).collect();
    assert_eq!(count, expected);
}

#[test]
fn names_are_as_printed() {
    let other = entry_rows().filter_map(|(row, address)| {
        let name = if address.subindex == 0 { &object(row.index).name } else { &entry(address).name };
        (name != row.name).then_some((row.name, name.as_str()))
    });
    departs(other, []);
}

#[test]
fn access_is_as_printed() {
    for (row, address) in entry_rows() {
        let expected = match row.access {
            Some(manual::Access::ReadOnly) => Access::Ro,
            Some(manual::Access::ReadWrite) => Access::Rw,
            None => continue,
        };
        let access = match entry(address).access {
            Access::Const => Access::Ro,
            access => access,
        };
        assert_eq!(access, expected, "{address}");
    }
}

#[test]
fn times_of_writing_are_as_printed() {
    for (row, address) in entry_rows() {
        let window = entry(address).written;
        match row.writing {
            "" => assert_eq!(window, None, "{address}"),
            // From Pre-Operational to Safe-Operational: before the change, in the state it starts from.
            "P->S" => assert_eq!(window, Some(WriteWindow::PreOp), "{address}"),
            other => panic!("{address}: {other} is no time of writing"),
        }
    }
}

#[test]
fn types_are_as_printed() {
    let mut typed = 0;
    for (row, address) in entry_rows().filter(|(row, _)| !row.data_type.is_empty()) {
        let printed = row.data_type.replace("UNINT", "UINT");
        let described = entry(address).data_type.to_string();
        let same = if printed == "STRING" { described.starts_with("STRING(") } else { described == printed };
        assert!(same, "{address}: {described}, printed {printed}");
        typed += 1;
    }
    assert_eq!(typed, 339 - 138);
}

#[test]
fn defaults_are_as_printed() {
    for (row, address) in entry_rows() {
        let default = entry(address).default.as_ref();
        match row.hex.split_once(", ") {
            Some((place, bits)) => assert_eq!(default, Some(&mapping(place, bits)), "{address}"),
            None if row.hex.is_empty() => assert_eq!(default, None, "{address}"),
            None if row.data_type == "STRING" => {
                assert_eq!(default, Some(&Value::Text(row.hex.to_owned())), "{address}");
            }
            None => assert_eq!(default, row.default().map(Value::Integer).as_ref(), "{address}"),
        }
    }
}

/// What a mapping object holds for `0x6040:00, 16`.
fn mapping(place: &str, bits: &str) -> Value {
    let digits: String = place.trim_start_matches("0x").split(':').collect();
    let place = i64::from_str_radix(&digits, 16).expect("an index and a subindex");
    Value::Integer(place << 8 | bits.trim().parse::<i64>().expect("a number of bits"))
}

#[test]
fn comments_on_missing_function_are_kept() {
    let mut without = 0;
    for (row, address) in entry_rows() {
        let functional = !row.comment.contains("without function");
        assert_eq!(entry(address).functional, functional, "{address}");
        without += usize::from(!functional);
    }
    assert_eq!(without, 35);
}

#[test]
fn axes_differ_only_in_comments() {
    let profile = device().objects.iter().filter(|object| object.index.0 >= 0x6000);
    for object in profile.filter(|object| object.axis.is_some_and(|axis| axis > 0)) {
        let distance = 0x800 * u16::from(object.axis.unwrap_or(0));
        let first = self::object(object.index.0 - distance);
        assert_eq!((&object.id, &object.name, object.kind), (&first.id, &first.name, first.kind));
        for (entry, first) in object.entries.iter().zip(&first.entries) {
            let mut entry = entry.clone();
            entry.address.index = first.address.index;
            entry.functional = first.functional;
            entry.note.clone_from(&first.note);
            entry.about.clone_from(&first.about);
            entry.origin = first.origin.clone();
            assert_eq!(&entry, first);
        }
    }
}

/// The chapter on coordinate systems, p. 17: activation changes the position of all axes. Each axis has an error code, p. 18.
#[test]
fn what_is_there_once_changes_all_axes() {
    let updates = |subindex| {
        let trigger = entry(Address { index: Index(0x5010), subindex }).trigger.as_ref();
        trigger.expect("it sets something off").updates.iter().map(|address| address.index.0)
    };
    let positions = [0x6064, 0x6864, 0x7064, 0x7864, 0x8064, 0x8864];
    assert!(updates(1).eq(positions) && updates(2).eq(positions));
    assert!(updates(4).eq([0x1001, 0x603F, 0x683F, 0x703F, 0x783F, 0x803F, 0x883F]));
}
