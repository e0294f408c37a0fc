//! PDOs and sync managers.

use devc::model::{Device, Direction, Pdo};
use devc_tests::esi_reader;

use crate::subjects::{corners, named, subjects};

/// PDOs of the model with what the file says of them, and the number of their sync manager.
fn pdos<'a>(
    model: &'a Device,
    read: &'a esi_reader::Device,
) -> impl Iterator<Item = (&'a Pdo, &'a esi_reader::Pdo, usize)> {
    let both = [(Direction::Rx, &read.rx_pdos, 2), (Direction::Tx, &read.tx_pdos, 3)];
    both.into_iter().flat_map(|(direction, read, manager)| {
        let pdos: Vec<_> = model.pdos_of(direction).collect();
        assert_eq!(pdos.len(), read.len());
        pdos.into_iter().map(move |pdo| {
            let found = read.iter().find(|read| read.index == pdo.index.0);
            (pdo, found.unwrap_or_else(|| panic!("{} is not in the file", pdo.index)), manager)
        })
    })
}

#[test]
fn pdos_are_those_of_the_model() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (pdo, read, manager) in pdos(model, read) {
                assert_eq!(read.index, pdo.index.0);
                assert_eq!(read.name, pdo.name, "{}", pdo.index);
                assert_eq!((read.fixed, read.mandatory), (pdo.fixed, pdo.mandatory), "{}", pdo.index);
                let excludes: Vec<_> = pdo.excludes.iter().map(|index| index.0).collect();
                assert_eq!(read.excludes, excludes, "{}", pdo.index);
                let assigned = model.sync_managers.iter().any(|it| it.pdos.contains(&pdo.index));
                assert_eq!(read.sync_manager, assigned.then_some(manager), "{}", pdo.index);
            }
        }
    }
}

#[test]
fn mapped_entries_are_those_of_the_model() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (pdo, read, _) in pdos(model, read) {
                assert_eq!(read.entries.len(), pdo.entries.len(), "{}", pdo.index);
                for (mapped, entry) in pdo.entries.iter().zip(&read.entries) {
                    assert_eq!(entry.bits, mapped.bits, "{}: {}", pdo.index, mapped.name);
                    match mapped.address {
                        Some(address) => {
                            assert_eq!(
                                (entry.index, entry.subindex),
                                (address.index.0, Some(address.subindex))
                            );
                            assert_eq!(entry.name.as_ref(), Some(&mapped.name));
                        }
                        None => assert!(entry.index == 0 && entry.subindex.is_none() && entry.name.is_none()),
                    }
                }
            }
        }
    }
}

/// What a file maps in another way than its dictionary has it: index of the object, and what is wrong.
fn contradictions(model: &Device, read: &esi_reader::Device) -> Vec<(u16, &'static str)> {
    let objects = read.dictionary.objects.iter();
    let values: Vec<_> = objects.flat_map(|object| read.dictionary.values(object).unwrap()).collect();
    let mut found = Vec::new();
    for (_, pdo, manager) in pdos(model, read) {
        for entry in pdo.entries.iter().filter(|entry| entry.index != 0) {
            let value =
                values.iter().find(|it| (it.index, Some(it.subindex)) == (entry.index, entry.subindex));
            let direction = if manager == 2 { 'R' } else { 'T' };
            let mapping = value.and_then(|value| value.flags.pdo_mapping.clone()).unwrap_or_default();
            let fault = match value {
                None => Some("missing"),
                Some(value) if value.bits != entry.bits => Some("width"),
                Some(value) if Some(&value.basic_type) != entry.data_type.as_ref() => Some("type"),
                Some(_) if !mapping.contains(direction) => Some("direction"),
                Some(_) => None,
            };
            // A type that is not that of the dictionary would mislead more than none.
            assert!(
                fault.is_none_or(|fault| fault == "direction" || entry.data_type.is_none()),
                "{:04X}",
                entry.index
            );
            found.extend(fault.map(|fault| (entry.index, fault)));
        }
    }
    found
}

#[test]
fn mapped_entries_are_in_the_dictionary_with_their_type_and_direction() {
    // The manual of the C-887 maps two objects of a mode that the device does not have.
    let profile_position = (0..6).flat_map(|axis| [0x6081 + axis * 0x800, 0x6083 + axis * 0x800]);
    let known =
        [("c887", profile_position.map(|index| (index, "missing")).collect()), ("corners", Vec::new())];
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
            for (_, pdo, _) in pdos(model, read) {
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
                assert!(!pdo.fixed || mapped.len() == used + 1, "{:04X}", pdo.index);
            }
        }
    }
}

#[test]
fn the_assignment_objects_name_the_pdos_that_name_a_sync_manager() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (manager, pdos) in [(2, &read.rx_pdos), (3, &read.tx_pdos)] {
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
fn sync_managers_are_those_of_the_model_in_their_order() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let kinds: Vec<_> = read.sync_managers.iter().map(|it| it.kind.as_str()).collect();
            assert_eq!(kinds, ["MBoxOut", "MBoxIn", "Outputs", "Inputs"]);
            assert_eq!(read.fmmus, ["Outputs", "Inputs", "MBoxState"]);
            for (manager, read) in model.sync_managers.iter().zip(&read.sync_managers) {
                assert_eq!((read.address, read.control), (manager.address, manager.control));
                assert_eq!((read.size, read.max_size), (manager.size, manager.max_size));
                assert_eq!(read.enabled, manager.size > 0);
            }
        }
    }
}

#[test]
fn a_sync_manager_is_as_long_as_what_is_assigned_to_it() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            for (manager, pdos) in [(2, &read.rx_pdos), (3, &read.tx_pdos)] {
                let assigned = pdos.iter().filter(|pdo| pdo.sync_manager == Some(manager));
                let bits: u32 = assigned.flat_map(|pdo| &pdo.entries).map(|entry| entry.bits).sum();
                assert_eq!(u32::from(read.sync_managers[manager].size), bits.div_ceil(8));
            }
        }
    }
}

#[test]
fn areas_do_not_overlap_even_with_three_buffers() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let mut areas: Vec<_> = read
                .sync_managers
                .iter()
                .map(|it| {
                    let buffers = if it.control & 0b11 == 0 { 3 } else { 1 };
                    (u32::from(it.address), u32::from(it.address) + buffers * u32::from(it.size))
                })
                .collect();
            areas.sort_unstable();
            assert!(areas.is_sorted_by(|one, next| one.1 <= next.0), "{}: {areas:X?}", model.name);
        }
    }
}

#[test]
fn padding_is_an_index_of_0_and_a_width() {
    let subject = corners();
    let xml = subject.xml.split_whitespace().collect::<String>();
    assert!(xml.contains("<Entry><Index>#x0</Index><BitLen>8</BitLen></Entry>"));
}
