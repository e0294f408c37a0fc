//! Mappings against tables 8 to 11, 18 to 21 and 30 to 33.

use std::collections::BTreeSet;

use devc::model::{Direction, Mapped, Pdo};
use devc_tests::manual::{self, AxisLetter, pmc_sc6};

use crate::{departs, device, fact, number, rows};

fn direction(direction: manual::Direction) -> Direction {
    match direction {
        manual::Direction::Rx => Direction::Rx,
        manual::Direction::Tx => Direction::Tx,
    }
}

/// The PDO of an axis as a mapping has it.
fn pdo(mapping: &str, axis: AxisLetter, wanted: manual::Direction) -> &'static Pdo {
    let of_configuration = |id: &str| {
        let found = device().configurations.iter().find(|configuration| configuration.id == id);
        &found.unwrap_or_else(|| panic!("there is no configuration {id}")).mapping
    };
    let pdos = match mapping {
        "standard" => &device().pdos,
        "ip" => of_configuration("interpolated-position"),
        "vl" => of_configuration("velocity"),
        other => panic!("{other} is a new mapping"),
    };
    let mut found =
        pdos.iter().filter(|pdo| (pdo.axis, pdo.direction) == (Some(number(axis)), direction(wanted)));
    let one = found.next().unwrap_or_else(|| panic!("{mapping} lacks a PDO for {axis:?}"));
    assert!(found.next().is_none(), "each axis has one PDO in a direction");
    one
}

/// Each row with the entry at its first byte.
fn mapped() -> impl Iterator<Item = (pmc_sc6::Mapped, &'static Mapped)> {
    rows::<pmc_sc6::Mapped>().into_iter().map(|row| {
        let entries = &pdo(row.mapping, row.axis, row.direction).entries;
        let found = entries.iter().find(|entry| entry.offset == u32::from(row.first) * 8);
        let found = found.unwrap_or_else(|| panic!("nothing starts at byte {}: {row:?}", row.first));
        (row, found)
    })
}

#[test]
fn entries_have_the_places_of_the_tables() {
    for (row, entry) in mapped() {
        assert_eq!(entry.bits, u32::from(row.last + 1 - row.first) * 8, "{row:?}");
    }
}

#[test]
fn tables_are_whole() {
    let mut seen = BTreeSet::new();
    for row in rows::<pmc_sc6::Mapped>().into_iter().filter(|row| seen.insert(row.table)) {
        let of_table = rows::<pmc_sc6::Mapped>().into_iter().filter(|other| other.table == row.table);
        let (count, last) = of_table.fold((0, 0), |(count, _), other| (count + 1, other.last));
        let pdo = pdo(row.mapping, row.axis, row.direction);
        assert_eq!((pdo.entries.len(), pdo.bytes()), (count, u32::from(last) + 1), "table {}", row.table);
    }
    assert_eq!(seen.len(), 12);
}

#[test]
fn types_are_as_printed() {
    let other = mapped()
        .filter(|(row, entry)| entry.data_type.map(|it| it.to_string()).as_deref() != Some(row.data_type));
    let why = "printed INT, which is no type of the manual and has the 2 bytes of INT16";
    let known = [(18, 3), (19, 3), (20, 3), (21, 3)];
    departs(other.map(|(row, _)| (row.table, row.first)), known.map(|place| (place, why)));
}

#[test]
fn names_are_as_printed() {
    for (row, entry) in mapped() {
        assert_eq!(entry.name, row.name, "{row:?}");
    }
}

#[test]
fn objects_are_as_printed() {
    for (row, entry) in mapped() {
        let address = entry.address.expect("nothing is padded");
        let object = device().object(address.index).expect("it is in the dictionary");
        let coordinate = &row.parameter[2..];
        let described = object.entry(address.subindex).and_then(|entry| entry.parameter.as_deref());
        assert_eq!(described.or(object.parameter.as_deref()), Some(coordinate), "{row:?}");
        let index = row.object.unwrap_or_else(|| {
            let coordinates = device().coordinates.as_ref().expect("they are described");
            let first = coordinates.address(coordinate).expect("its line has an index");
            first.index.0 + 0x8000 * u16::from(number(row.axis))
        });
        assert_eq!(address.index.0, index, "{row:?}");
        // The tables name objects alone; an object of several is mapped by its first entry.
        assert_eq!(address.subindex, u8::from(object.entries.len() > 1), "{row:?}");
    }
}

#[test]
fn pdos_hold_so_many_parameters() {
    let most = fact("pdo-parameters-max").parse().ok();
    assert!(device().pdos.iter().all(|pdo| pdo.max_entries == most && !pdo.fixed));
    for row in rows::<pmc_sc6::MappingParameter>() {
        assert_eq!(Some(row.last + 1 - row.first), most);
        let parameter = device().parameters.iter().find(|parameter| parameter.id == row.parameter);
        let parameter = parameter.unwrap_or_else(|| panic!("{} is not described", row.parameter));
        let name = format!("{:?}PDO mapping, axis {:?}", row.direction, row.axis);
        assert_eq!(parameter.name, name);
        assert_eq!((row.first, parameter.elements), (0, Some(row.last + 1)), "{}", row.parameter);
        let pdo = pdo("standard", row.axis, row.direction);
        assert!(pdo.about.as_ref().is_some_and(|about| about.contains(row.parameter)), "{}", row.parameter);
    }
}

#[test]
fn types_are_those_of_table_2() {
    for row in rows::<pmc_sc6::DataType>().into_iter().filter(|row| !row.name.starts_with("STR")) {
        let known: devc::model::DataType =
            row.name.parse().unwrap_or_else(|()| panic!("{} is unknown", row.name));
        assert_eq!(known.bits(), u32::from(row.bits), "{}", row.name);
        let range = known.range().map(|(min, max)| (min.to_string(), max.to_string()));
        // Numbers with a fraction have no range of whole numbers.
        let printed = Some((row.min.to_owned(), row.max.to_owned())).filter(|_| row.name != "REAL32");
        assert_eq!(range, printed, "{}", row.name);
    }
}
