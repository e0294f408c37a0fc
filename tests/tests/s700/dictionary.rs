//! The object dictionary against the tables of cyclic values.

use std::collections::BTreeSet;

use devc::model::{Address, Device, Entry, Index, Object};
use devc_tests::manual::{Direction, Sub, s700};

use crate::{MEMBERS, departs, device, family, number, plain, rows};

/// Names that the description does not take as they stand, and what it makes of them.
const RENAMED: [((&str, &str), &str); 2] = [
    (("ASCII input data", "ASCII data"), "the object is in both directions"),
    (("ASCII output data", "ASCII data"), "the object is in both directions"),
];

/// Objects outside the tables of cyclic values that the text names; all others are assumed or follow from PDOs.
const IN_THE_TEXT: [u16; 4] = [0x1C12, 0x1C13, 0x6060, 0x60C2];

/// The unit that each wording of the manual stands for.
const UNITS: [(&str, Option<&str>); 10] = [
    ("", None),
    ("3280 increments: peak current", Some("peak-current")),
    ("17896 increments: 1 rpm", Some("velocity-feed-forward")),
    ("139.81 counts: 1 rpm", Some("velocity")),
    ("increments per motor revolution", Some("position")),
    ("mV", Some("millivolt")),
    ("mA", Some("milliampere")),
    ("V", Some("volt")),
    ("SI", None),
    ("as TEMPM is configured", None),
];

/// The subindices of a row; 0 where none is printed.
fn addresses(row: &s700::Object) -> Vec<Address> {
    let (first, last) = match row.sub {
        Sub::Variable => (0, 0),
        Sub::One(subindex) => (subindex, subindex),
        Sub::Range(first, last) => (first, last),
    };
    (first..=last).map(|subindex| Address { index: Index(row.index), subindex }).collect()
}

/// Every entry that the tables have, with its row and object, on every member.
fn entries() -> impl Iterator<Item = (s700::Object, &'static Object, &'static Entry)> {
    let devices = MEMBERS.into_iter().map(device);
    devices.flat_map(|device| rows::<s700::Object>().into_iter().flat_map(move |row| found(device, row)))
}

fn found(device: &'static Device, row: s700::Object) -> Vec<(s700::Object, &'static Object, &'static Entry)> {
    let of = |address: Address| {
        let object = device.object(address.index)?;
        Some((row.clone(), object, object.entry(address.subindex)?))
    };
    let missing = || panic!("the description of {} lacks {row:?}", device.id);
    addresses(&row).into_iter().map(|address| of(address).unwrap_or_else(missing)).collect()
}

/// All that is said of an entry.
fn text(object: &Object, entry: &Entry) -> String {
    let unit = entry.unit.as_deref().and_then(|id| device(MEMBERS[0]).unit(id));
    let parts = [
        object.about.as_deref(),
        object.note.as_deref(),
        entry.about.as_deref(),
        entry.note.as_deref(),
        parameter(object, entry),
        unit.and_then(|unit| unit.about.as_deref()),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join("\n")
}

fn parameter<'a>(object: &'a Object, entry: &'a Entry) -> Option<&'a str> {
    entry.parameter.as_deref().or(object.parameter.as_deref())
}

#[test]
fn every_value_is_there_with_its_type() {
    let mut compared = 0;
    for (row, _, entry) in entries() {
        assert_eq!(entry.data_type.to_string(), row.data_type, "{}", entry.address);
        compared += 1;
    }
    // 73 rows, three of which stand for sixteen entries.
    assert_eq!(compared, (73 + 3 * 15) * MEMBERS.len());
}

#[test]
fn every_value_is_mappable_in_its_direction() {
    let of = |wanted| -> BTreeSet<_> {
        let rows = rows::<s700::Object>().into_iter().filter(|row| row.direction == wanted);
        rows.flat_map(|row| addresses(&row)).collect()
    };
    let (rx, tx) = (of(Direction::Rx), of(Direction::Tx));
    for (_, _, entry) in entries() {
        assert_eq!(entry.pdo.rx(), rx.contains(&entry.address), "{}", entry.address);
        assert_eq!(entry.pdo.tx(), tx.contains(&entry.address), "{}", entry.address);
        assert_eq!(entry.access.writable(), rx.contains(&entry.address), "{}", entry.address);
    }
}

#[test]
fn arrays_end_where_the_tables_end() {
    for (row, object, _) in entries() {
        let same = rows::<s700::Object>().into_iter().filter(|other| other.index == row.index);
        let printed = same.flat_map(|row| addresses(&row)).map(|address| address.subindex).max();
        assert_eq!(Some(object.highest_subindex()), printed, "{}", object.index);
    }
}

#[test]
fn names_are_as_printed() {
    let other = entries().filter_map(|(row, object, entry)| {
        // A row of sixteen entries has the name of the object.
        let one = matches!(row.sub, Sub::One(1..));
        let name = if one { &entry.name } else { &object.name };
        (plain(name) != plain(row.name)).then_some((row.name, name.as_str()))
    });
    departs(other, RENAMED);
}

#[test]
fn ascii_commands_are_as_printed() {
    let other = entries().filter(|(row, object, entry)| {
        // The macro variables are ASCII variables by their names.
        let printed = match row.name.split(' ').next() {
            Some(name) if name.starts_with("DPRVAR") && row.data_type == "INT32" => name,
            _ => row.ascii,
        };
        parameter(object, entry).unwrap_or_default() != printed
    });
    departs(other.map(|(row, ..)| row.index), []);
}

#[test]
fn parameters_and_variables_are_named() {
    for (row, object, entry) in entries() {
        let text = text(object, entry);
        for name in row.parameters.iter().chain(&row.variables) {
            // PTBASE is the time of a bus cycle.
            let wanted = if *name == "PTBASE" { "bus cycle" } else { name };
            assert!(text.contains(wanted), "{}: {name} is not in {text:?}", entry.address);
        }
    }
}

#[test]
fn units_are_as_printed() {
    let other = entries().filter(|(row, _, entry)| {
        let unit = UNITS.iter().find(|(printed, _)| *printed == row.unit);
        let (_, unit) = unit.unwrap_or_else(|| panic!("{}: the unit {:?} is new", entry.address, row.unit));
        entry.unit.as_deref() != *unit
    });
    departs(other.map(|(row, _, _)| row.index), [(0x20A0, "assumed to be that of the encoder's positions")]);
}

#[test]
fn set_values_name_their_opmode() {
    for (row, object, entry) in entries() {
        let Some(opmode) = row.opmode else { continue };
        let opmode = format!("OPMODE {opmode}");
        assert!(text(object, entry).contains(&opmode), "{} is for {opmode}", entry.address);
        let of_mode = |about: &str| about.contains(&opmode);
        let mode = family().members[0].modes.iter().find(|mode| mode.about.as_deref().is_some_and(of_mode));
        let mode = mode.unwrap_or_else(|| panic!("no mode is {opmode}"));
        assert!(mode.objects.contains(&entry.address), "{} is for mode {}", entry.address, mode.code);
    }
}

#[test]
fn other_objects_are_assumed_or_in_the_text() {
    let printed: BTreeSet<u16> = rows::<s700::Object>().iter().map(|row| row.index).collect();
    for device in &family().members {
        for object in device.objects.iter().filter(|object| !printed.contains(&object.index.0)) {
            let index = object.index;
            let key = index.to_string();
            let assumed =
                device.assumptions.iter().any(|assumption| assumption.at.to_string().starts_with(&key));
            let pdo = matches!(index.0, 0x1600..=0x1C00);
            assert!(assumed || pdo || IN_THE_TEXT.contains(&index.0), "{index} is not in the manual");
        }
    }
}

#[test]
fn assignment_and_mapping_objects_are_those_of_the_text() {
    for (key, direction) in [("rx-assignment", "rx"), ("tx-assignment", "tx")] {
        let index = Index(u16::try_from(number(key)).expect("an index"));
        assert!(MEMBERS.into_iter().all(|member| device(member).object(index).is_some()), "{direction}");
    }
}
