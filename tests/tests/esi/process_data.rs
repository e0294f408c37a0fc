//! PDOs and sync managers.

use devc::model::{Device, Direction, Pdo};
use devc_tests::esi_reader;

use std::collections::BTreeSet;

use crate::subjects::{corners, is_named, named, subjects};

/// PDOs of the model with what the file says of them.
fn pdos<'a>(
    model: &'a Device,
    read: &'a esi_reader::Device,
) -> impl Iterator<Item = (&'a Pdo, &'a esi_reader::Pdo)> {
    let both = [(Direction::Rx, &read.rx_pdos), (Direction::Tx, &read.tx_pdos)];
    both.into_iter().flat_map(|(direction, read)| {
        let pdos: Vec<_> = model.pdos_of(direction).collect();
        assert_eq!(pdos.len(), read.len());
        pdos.into_iter().map(move |pdo| {
            let found = read.iter().find(|read| read.index == pdo.index.0);
            (pdo, found.unwrap_or_else(|| panic!("{} is not in the file", pdo.index)))
        })
    })
}

#[test]
fn pdos_are_those_of_the_model() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let managers = &read.sync_managers;
            for (pdo, read) in pdos(model, read) {
                assert_eq!(read.index, pdo.index.0);
                assert!(is_named(model, &read.name, &pdo.name, pdo.axis), "{}: {}", pdo.index, read.name);
                assert_eq!((read.fixed, read.mandatory), (pdo.fixed, pdo.mandatory), "{}", pdo.index);
                let named = pdo.excludes.iter().all(|index| read.excludes.contains(&index.0));
                assert!(named, "{}: {:X?}", pdo.index, read.excludes);
                let manager = model.sync_managers.iter().find(|it| it.pdos.contains(&pdo.index));
                let manager = manager.map(|it| it.address);
                assert_eq!(read.sync_manager.map(|place| managers[place].address), manager, "{}", pdo.index);
            }
        }
    }
}

#[test]
fn mapped_entries_are_those_of_the_model() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (pdo, read) in pdos(model, read) {
                assert_eq!(read.entries.len(), pdo.entries.len(), "{}", pdo.index);
                for (mapped, entry) in pdo.entries.iter().zip(&read.entries) {
                    assert_eq!(entry.bits, mapped.bits, "{}: {}", pdo.index, mapped.name);
                    match mapped.address {
                        Some(address) => {
                            assert_eq!(
                                (entry.index, entry.subindex),
                                (address.index.0, Some(address.subindex))
                            );
                            let axis = model.object(address.index).map_or(pdo.axis, |object| object.axis);
                            let name = entry.name.as_deref().unwrap_or_default();
                            assert!(is_named(model, name, &mapped.name, axis), "{}: {name}", pdo.index);
                        }
                        None => assert!(entry.index == 0 && entry.subindex.is_none() && entry.name.is_none()),
                    }
                }
            }
        }
    }
}

/// The width of a type by its name in ETG.1020.
fn width(name: &str) -> Option<u32> {
    let known = [
        ("BOOL", 1),
        ("BYTE", 8),
        ("SINT", 8),
        ("USINT", 8),
        ("WORD", 16),
        ("INT", 16),
        ("UINT", 16),
        ("DWORD", 32),
        ("DINT", 32),
        ("UDINT", 32),
        ("REAL", 32),
        ("LINT", 64),
        ("ULINT", 64),
        ("LREAL", 64),
    ];
    let number = |digits: &str| digits.parse::<u32>().ok();
    let named = known.iter().find(|(known, _)| *known == name).map(|(_, bits)| *bits);
    let array = || name.strip_prefix("ARRAY [0..")?.strip_suffix("] OF BYTE").and_then(number);
    named
        .or_else(|| array().map(|last| (last + 1) * 8))
        .or_else(|| name.strip_prefix("BIT").and_then(number))
        .or_else(|| name.trim_start_matches('U').strip_prefix("INT").and_then(number))
        .or_else(|| name.strip_prefix("STRING(")?.strip_suffix(')').and_then(number).map(|bytes| bytes * 8))
}

#[test]
fn what_the_dictionary_lacks_has_a_type_that_tells_its_width() {
    let pdo = corners().esi.devices[0].tx_pdos.iter().find(|pdo| pdo.index == 0x1A01).unwrap();
    let types: Vec<_> = pdo.entries.iter().map(|entry| entry.data_type.as_deref().unwrap()).collect();
    let bits = "BIT1 BIT7 BYTE WORD DWORD ULINT UINT24";
    assert_eq!(types[..7].join(" "), bits);
    assert_eq!(types[7..], ["ARRAY [0..11] OF BYTE", "DWORD"]);
}

#[test]
fn pdos_and_what_they_carry_have_names_of_their_own() {
    // the maker of the SV660N has one name for all of a direction, and the description allows it
    for subject in subjects().iter().filter(|subject| subject.family.id != "sv660n") {
        for (_, read) in subject.devices() {
            for pdos in [&read.rx_pdos, &read.tx_pdos] {
                let names: BTreeSet<_> = pdos.iter().map(|pdo| &pdo.name).collect();
                assert_eq!(names.len(), pdos.len(), "{}: {names:?}", read.name);
            }
        }
    }
    let names = |index| {
        let pdo = named("c887").esi.devices[0].rx_pdos.iter().find(|pdo| pdo.index == index).unwrap();
        (pdo.name.as_str(), pdo.entries[0].name.as_deref().unwrap())
    };
    assert_eq!(names(0x1600), ("RxPDO - CSP (X)", "Controlword (X)"));
    assert_eq!(names(0x1650), ("RxPDO - CSP (W)", "Controlword (W)"));
}

/// The manual of the S700 lets a master assign one PDO of a direction (3.5, "slots = 1"); the C-887 takes seven.
#[test]
fn where_one_pdo_is_taken_at_a_time_each_excludes_all_others() {
    for (_, read) in named("s700").devices() {
        for pdos in [&read.rx_pdos, &read.tx_pdos] {
            for pdo in pdos {
                let others = pdos.iter().map(|other| other.index).filter(|other| *other != pdo.index);
                assert_eq!(pdo.excludes, others.collect::<Vec<_>>(), "{:04X}", pdo.index);
            }
        }
    }
    let c887 = &named("c887").esi.devices[0].rx_pdos;
    assert!(c887.iter().all(|pdo| pdo.excludes.len() < c887.len() - 1));
}

/// What a file maps in another way than its dictionary has it: index of the object, and what is wrong.
fn contradictions(model: &Device, read: &esi_reader::Device) -> Vec<(u16, &'static str)> {
    let objects = read.dictionary.objects.iter();
    let values: Vec<_> = objects.flat_map(|object| read.dictionary.values(object).unwrap()).collect();
    let mut found = Vec::new();
    for (described, pdo) in pdos(model, read) {
        for entry in pdo.entries.iter().filter(|entry| entry.index != 0) {
            let value =
                values.iter().find(|it| (it.index, Some(it.subindex)) == (entry.index, entry.subindex));
            let direction = if described.direction == Direction::Rx { 'R' } else { 'T' };
            let mapping = value.and_then(|value| value.flags.pdo_mapping.clone()).unwrap_or_default();
            let fault = match value {
                None => Some("missing"),
                Some(value) if value.bits != entry.bits => Some("width"),
                Some(value) if Some(&value.basic_type) != entry.data_type.as_ref() => Some("type"),
                Some(_) if !mapping.contains(direction) => Some("direction"),
                Some(_) => None,
            };
            // Readers stop at an entry without a type. One of another width would move all that follows.
            let data_type =
                entry.data_type.as_deref().unwrap_or_else(|| panic!("{:04X}: no type", entry.index));
            assert_eq!(width(data_type), Some(entry.bits), "{:04X}: {data_type}", entry.index);
            found.extend(fault.map(|fault| (entry.index, fault)));
        }
    }
    found
}

#[test]
fn mapped_entries_are_in_the_dictionary_with_their_type_and_direction() {
    // The manual of the C-887 maps two objects of a mode that the device does not have.
    let profile_position = (0..6).flat_map(|axis| [0x6081 + axis * 0x800, 0x6083 + axis * 0x800]);
    let known = [
        ("c887", profile_position.map(|index| (index, "missing")).collect()),
        ("without_inputs", Vec::new()),
    ];
    for (family, expected) in known {
        for (model, read) in named(family).devices() {
            assert_eq!(contradictions(model, read), expected, "{family}");
        }
    }
}

#[test]
fn what_a_file_maps_in_another_way_than_its_dictionary_has_it_is_in_the_model() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (index, fault) in contradictions(model, read) {
                let mut mapped = model
                    .pdos
                    .iter()
                    .flat_map(|pdo| &pdo.entries)
                    .filter(|it| it.address.is_some_and(|address| address.index.0 == index));
                let as_in_the_file = mapped.any(|mapped| {
                    match (fault, mapped.address.and_then(|address| model.entry(address))) {
                        ("missing", entry) => entry.is_none(),
                        ("width", Some(entry)) => mapped.bits != entry.data_type.bits(),
                        ("direction", Some(entry)) => !(entry.pdo.rx() && entry.pdo.tx()),
                        _ => false,
                    }
                });
                assert!(as_in_the_file, "{}: {index:04X} {fault}", model.name);
            }
        }
    }
}

#[test]
fn each_pdo_is_an_object_that_maps_what_it_carries() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (_, pdo) in pdos(model, read) {
                let object = read.dictionary.objects.iter().find(|object| object.index == pdo.index).unwrap();
                let values = read.dictionary.values(object).unwrap();
                let mapped: Vec<_> = values.iter().map(|it| it.info.default.clone().unwrap()).collect();
                let expected = pdo.entries.iter().map(|it| {
                    let [low, high] = it.index.to_le_bytes();
                    vec![it.bits as u8, it.subindex.unwrap_or_default(), low, high]
                });
                let used = pdo.entries.len();
                assert_eq!(mapped[0], [used as u8], "{:04X}", pdo.index);
                assert_eq!(mapped[1..=used], expected.collect::<Vec<_>>(), "{:04X}", pdo.index);
                assert!(mapped[used + 1..].iter().all(|it| *it == [0; 4]), "{:04X}", pdo.index);
                // that of the SV660N has ten subindices, whatever it maps
                let is_exact = subject.family.id == "sv660n" || mapped.len() == used + 1;
                assert!(!pdo.fixed || is_exact, "{:04X}", pdo.index);
            }
        }
    }
}

#[test]
fn the_assignment_objects_name_the_pdos_that_name_a_sync_manager() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (manager, kind) in read.sync_managers.iter().map(|it| it.kind.as_str()).enumerate() {
                let pdos = match kind {
                    "Outputs" => &read.rx_pdos,
                    "Inputs" => &read.tx_pdos,
                    _ => continue,
                };
                let assigned = pdos.iter().filter(|pdo| pdo.sync_manager == Some(manager));
                let assigned: Vec<_> = assigned.map(|pdo| pdo.index.to_le_bytes().to_vec()).collect();
                let index = 0x1C10 + u16::try_from(manager).unwrap();
                let object = read.dictionary.objects.iter().find(|object| object.index == index).unwrap();
                let values = read.dictionary.values(object).unwrap();
                assert_eq!(values[0].info.default, Some(vec![assigned.len() as u8]), "{}", model.name);
                let named = values[1..=assigned.len()].iter().map(|it| it.info.default.clone().unwrap());
                assert_eq!(named.collect::<Vec<_>>(), assigned, "{}", model.name);
            }
        }
    }
}

#[test]
fn pdos_that_exclude_each_other_do_so_both_ways_and_are_not_assigned_together() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            for pdos in [&read.rx_pdos, &read.tx_pdos] {
                for pdo in pdos {
                    for other in pdos.iter().filter(|other| pdo.excludes.contains(&other.index)) {
                        assert!(other.excludes.contains(&pdo.index), "{:04X} {:04X}", pdo.index, other.index);
                        assert!(pdo.sync_manager.is_none() || other.sync_manager.is_none());
                    }
                }
            }
        }
    }
}

#[test]
fn padding_is_an_index_of_0_and_a_width() {
    let subject = corners();
    let xml = subject.xml.split_whitespace().collect::<String>();
    assert!(xml.contains("<Entry><Index>#x0</Index><BitLen>8</BitLen></Entry>"));
}
