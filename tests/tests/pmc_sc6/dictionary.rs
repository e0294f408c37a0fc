//! The profile's objects against tables 34 and 35.

use std::collections::{BTreeMap, BTreeSet};

use devc::model::{Address, Index, Kind, Object, Value};
use devc_tests::manual::{Sub, pmc_sc6};

use crate::{departs, device, plain, rows};

fn object(index: u16) -> &'static Object {
    device().object(Index(index)).unwrap_or_else(|| panic!("the description lacks 0x{index:04X}"))
}

/// The subindices that a row stands for; none for the head of an object of several.
fn subindices(sub: Sub) -> Vec<u8> {
    match sub {
        Sub::Variable => Vec::new(),
        Sub::One(subindex) => vec![subindex],
        Sub::Range(first, last) => (first..=last).collect(),
    }
}

/// Each entry of a row with its subindex.
fn entries() -> impl Iterator<Item = (pmc_sc6::Object, u8)> {
    rows::<pmc_sc6::Object>()
        .into_iter()
        .flat_map(|row| subindices(row.sub).into_iter().map(move |subindex| (row.clone(), subindex)))
}

fn entry(index: u16, subindex: u8) -> &'static devc::model::Entry {
    let found = object(index).entry(subindex);
    found.unwrap_or_else(|| panic!("the description lacks 0x{index:04X}:{subindex:02X}"))
}

/// The heads of objects of several entries.
fn heads() -> impl Iterator<Item = pmc_sc6::Object> {
    rows::<pmc_sc6::Object>().into_iter().filter(|row| row.sub == Sub::Variable)
}

#[test]
fn objects_are_132_with_242_entries_and_one_more_for_each_axis() {
    let profile = device().objects.iter().filter(|object| (0x6000..0x8000).contains(&object.index.0));
    let described: BTreeSet<Address> =
        profile.flat_map(|object| object.entries.iter().map(|entry| entry.address)).collect();
    let printed: BTreeSet<Address> =
        entries().map(|(row, subindex)| Address { index: Index(row.index), subindex }).collect();
    assert_eq!(printed.len(), 242);
    assert_eq!(printed.iter().map(|address| address.index).collect::<BTreeSet<_>>().len(), 132);
    let why = "in the standard mapping, but not in the tables";
    let known = [(0x60FE, 0), (0x60FE, 1), (0x68FE, 0), (0x68FE, 1)];
    let other = described.symmetric_difference(&printed);
    departs(other.map(|it| (it.index.0, it.subindex)), known.map(|place| (place, why)));
}

#[test]
fn names_are_as_printed() {
    let mut other = BTreeSet::new();
    // The row of twenty is compared by its first.
    for (row, subindex) in
        entries().filter(|(row, subindex)| row.sub == Sub::One(*subindex) || *subindex == 1)
    {
        let object = object(row.index);
        let name = if object.kind == Kind::Var { &object.name } else { &entry(row.index, subindex).name };
        if plain(name) != plain(row.name) {
            other.insert((row.index, subindex, name.as_str()));
        }
    }
    let axes = [(0x60E3, 1, "1st supported homing method"), (0x68E3, 1, "1st supported homing method")];
    departs(other, axes.map(|row| (row, "one row for twenty")));
}

#[test]
fn names_of_objects_are_as_printed() {
    for row in heads() {
        assert_eq!(plain(&object(row.index).name), plain(row.name), "0x{:04X}", row.index);
    }
}

#[test]
fn ticks_are_as_printed() {
    for (row, subindex) in entries() {
        let described = entry(row.index, subindex).pdo;
        let printed = (row.tx, row.rx);
        assert_eq!((Some(described.tx()), Some(described.rx())), printed, "0x{:04X}:{subindex}", row.index);
    }
}

#[test]
fn coordinates_are_as_printed() {
    for (row, subindex) in entries() {
        let object = object(row.index);
        let printed = match row.parameter.split_once(':') {
            // The one range: A619[0]:A619[19] from subindex 1 on.
            Some((first, _)) => first.replace("[0]", &format!("[{}]", subindex - 1)),
            None => row.parameter.to_owned(),
        };
        let described = entry(row.index, subindex).parameter.as_ref();
        let described = described.or(object.parameter.as_ref().filter(|_| object.kind == Kind::Var));
        assert_eq!(described.cloned().unwrap_or_default(), printed, "0x{:04X}:{subindex}", row.index);
    }
}

#[test]
fn objects_of_one_value_and_of_several_are_as_printed() {
    let several: BTreeSet<u16> = heads().map(|row| row.index).collect();
    for (row, _) in entries() {
        assert_eq!(object(row.index).kind != Kind::Var, several.contains(&row.index), "0x{:04X}", row.index);
    }
}

#[test]
fn kinds_are_as_printed() {
    for row in heads() {
        let printed = if row.shape == "Array" { Kind::Array } else { Kind::Record };
        assert_eq!(object(row.index).kind, printed, "0x{:04X}", row.index);
    }
}

#[test]
fn counts_are_as_printed() {
    let mut elements = Vec::new();
    for head in heads() {
        let object = object(head.index);
        let count = object.entries.len() - 1;
        if head.elements.map(usize::from) != Some(count) {
            elements.push((head.index, head.elements, count));
        }
        let constant = rows::<pmc_sc6::Object>()
            .into_iter()
            .find(|row| row.index == head.index && row.sub == Sub::One(0));
        let constant = constant.and_then(|row| row.constant).map(|constant| Value::Integer(constant.into()));
        assert_eq!(entry(head.index, 0).default, constant, "0x{:04X}", head.index);
    }
    let listed = "six entries are listed, as the profile has them";
    let counted = "two entries are listed, and the constant is 2";
    let known = [
        ((0x60C4, Some(5), 6), listed),
        ((0x68C4, Some(5), 6), listed),
        ((0x60D0, Some(3), 2), counted),
        ((0x68D0, Some(3), 2), counted),
    ];
    departs(elements, known);
}

#[test]
fn limits_of_functions_are_kept() {
    let mut without = BTreeMap::new();
    for (row, subindex) in entries() {
        let entry = entry(row.index, subindex);
        assert_eq!(entry.functional, row.note != "no function", "{}", entry.address);
        *without.entry(row.note).or_insert(0) += 1;
        if row.note == "revolution length" {
            assert!(
                entry.note.as_deref().is_some_and(|note| note.contains("revolution")),
                "{}",
                entry.address
            );
        }
        if row.note == "only bit 7" {
            let polarity = device().word("polarity").expect("it is described");
            let bits = polarity.fields.iter().filter(|field| !field.reserved).map(|field| field.low);
            assert_eq!(bits.collect::<Vec<_>>(), [7]);
        }
    }
    assert_eq!(without.get("no function"), Some(&14));
}

#[test]
fn axes_are_alike_but_for_misprints() {
    let second = device().objects.iter().filter(|object| object.axis == Some(1));
    let other = second.filter(|object| object.index.0 >= 0x6000).filter(|object| {
        let distance = if object.index.0 >= 0x8000 { 0x8000 } else { 0x800 };
        let first = self::object(object.index.0 - distance);
        let mut moved = Object::clone(object);
        moved.index = first.index;
        moved.axis = first.axis;
        for entry in &mut moved.entries {
            entry.address.index = first.index;
        }
        moved != *first
    });
    let name = "another name is printed for axis A";
    let kind = "another kind is printed for axis A";
    let known = [(0x687B, name), (0x68A4, name), (0x68C1, kind), (0x68C2, kind), (0x68C4, kind)];
    departs(other.map(|object| object.index.0), known);
}

#[test]
fn other_objects_are_assumed() {
    let printed: BTreeSet<u16> = rows::<pmc_sc6::Object>().iter().map(|row| row.index).collect();
    let axis_a = device().objects.iter().filter(|object| object.axis != Some(1));
    let other = axis_a.filter(|object| !printed.contains(&object.index.0)).filter(|object| {
        let key = object.index.to_string();
        let parameter = object.parameter.as_deref().unwrap_or(&key);
        let assumed = |at: &str| at.starts_with(&key) || at.starts_with(parameter);
        !device().assumptions.iter().any(|assumption| assumed(&assumption.at.to_string()))
    });
    let why = "follows from the PDOs, of which some is assumed";
    let derived = [0x1C00, 0x1C12, 0x1C13];
    departs(other.map(|object| object.index.0), derived.map(|index| (index, why)));
}
