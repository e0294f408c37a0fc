//! How composite types lie in memory.

use std::collections::BTreeSet;

use crate::subjects::{corners, subjects};

#[test]
fn subindex_0_is_a_byte_and_the_rest_starts_at_bit_16() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            for (name, composite) in read.dictionary.types.iter().filter(|(_, it)| !it.items.is_empty()) {
                let [count, first, ..] = composite.items.as_slice() else { panic!("{name} has one member") };
                let place = (count.subindex, count.type_name.as_str(), count.bits, count.offset);
                assert_eq!(place, (Some(0), "USINT", 8, 0), "{name}");
                assert_eq!(first.offset, 16, "{name}");
            }
        }
    }
}

#[test]
fn members_follow_without_gaps_and_whole_bytes_start_at_a_byte() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            for (name, composite) in read.dictionary.types.iter().filter(|(_, it)| !it.items.is_empty()) {
                let mut free = 16;
                for item in &composite.items[1..] {
                    let expected = if item.bits < 8 { free } else { free + (8 - free % 8) % 8 };
                    assert_eq!(item.offset, expected, "{name}: {}", item.name);
                    free = item.offset + item.bits;
                }
                assert_eq!(composite.bits, free + (8 - free % 8) % 8, "{name}");
            }
        }
    }
}

#[test]
fn members_have_the_size_of_their_type_and_names_of_their_own() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            let types = &read.dictionary.types;
            for (name, composite) in types {
                for item in &composite.items {
                    assert_eq!(item.bits, types[&item.type_name].bits, "{name}: {}", item.name);
                }
                let names: BTreeSet<_> = composite.items.iter().map(|item| &item.name).collect();
                assert_eq!(names.len(), composite.items.len(), "{name} repeats a name");
            }
            for object in &read.dictionary.objects {
                assert_eq!(object.bits, types[&object.type_name].bits, "{:04X}", object.index);
            }
        }
    }
}

#[test]
fn an_array_has_subindex_0_and_all_elements_as_one() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            let types = &read.dictionary.types;
            for (name, composite) in types {
                let Some(elements) = composite.items.iter().find(|item| item.subindex.is_none()) else {
                    continue;
                };
                assert_eq!(composite.items.len(), 2, "{name}");
                assert_eq!(elements.type_name, format!("{name}ARR"));
                let array = &types[&elements.type_name];
                let (first, number) = array.array.unwrap();
                assert_eq!(first, 1, "{name}");
                assert_eq!(array.bits, number * types[array.base.as_ref().unwrap()].bits, "{name}");
            }
        }
    }
}

#[test]
fn elements_that_differ_in_access_make_a_record() {
    let subject = corners();
    let types = &subject.esi.devices[0].dictionary.types;
    assert!(types.contains_key("DT2002ARR"), "alike");
    assert!(!types.contains_key("DT2003ARR"), "one element can be written");
}

#[test]
fn bits_lie_side_by_side() {
    let subject = corners();
    let record = &subject.esi.devices[0].dictionary.types["DT2001"];
    let offsets: Vec<_> = record.items.iter().map(|item| (item.bits, item.offset)).collect();
    assert_eq!(offsets, [(8, 0), (8, 16), (16, 24), (8, 40), (8, 48), (1, 56), (3, 57), (40, 64)]);
    assert_eq!(record.bits, 104);
}
