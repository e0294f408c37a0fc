//! Sync managers: an ESI does not number them, so that all that refers to one counts.

use devc_tests::esi_reader::{Device, Object};

use crate::subjects::{named, subjects};

/// What a file has to say of a device, written down by hand.
struct Wired {
    family: &'static str,
    /// What each `Sm` is for, in order.
    managers: &'static [&'static str],
    fmmus: &'static [&'static str],
    /// The index of each PDO with the place of its `Sm`.
    pdos: &'static [(u16, usize)],
    /// 0x1C00 from subindex 1 on, as ETG.1000.6 has it: 1 and 2 mail from and to the master, 3 outputs, 4 inputs.
    kinds: &'static [u8],
    /// The assignment objects with what they name: 0x1C10 and the place of the `Sm`.
    assignments: &'static [(u16, &'static [u16])],
}

const WIRED: [Wired; 4] = [
    Wired {
        family: "without_outputs",
        managers: &["MBoxOut", "MBoxIn", "Inputs"],
        fmmus: &["Inputs", "MBoxState"],
        pdos: &[(0x1A00, 2)],
        kinds: &[1, 2, 4],
        assignments: &[(0x1C12, &[0x1A00])],
    },
    Wired {
        family: "without_inputs",
        managers: &["Outputs", "MBoxOut", "MBoxIn"],
        fmmus: &["Outputs", "MBoxState"],
        pdos: &[(0x1600, 0)],
        kinds: &[3, 1, 2],
        assignments: &[(0x1C10, &[0x1600])],
    },
    Wired {
        family: "without_mailbox",
        managers: &["Outputs", "Inputs"],
        fmmus: &["Outputs", "Inputs"],
        pdos: &[(0x1600, 0), (0x1A00, 1)],
        kinds: &[3, 4],
        assignments: &[(0x1C10, &[0x1600]), (0x1C11, &[0x1A00])],
    },
    Wired {
        family: "five_managers",
        managers: &["MBoxOut", "MBoxIn", "Outputs", "Inputs", "Outputs"],
        fmmus: &["Outputs", "Outputs", "Inputs", "MBoxState"],
        pdos: &[(0x1600, 2), (0x1601, 4), (0x1A00, 3)],
        kinds: &[1, 2, 3, 4, 3],
        assignments: &[(0x1C12, &[0x1600]), (0x1C13, &[0x1A00]), (0x1C14, &[0x1601])],
    },
];

fn object(device: &Device, index: u16) -> &Object {
    let found = device.dictionary.objects.iter().find(|object| object.index == index);
    found.unwrap_or_else(|| panic!("there is no {index:04X}"))
}

/// The defaults of an object from subindex 1 on, as many as subindex 0 says.
fn used(device: &Device, index: u16) -> Vec<Vec<u8>> {
    let values = device.dictionary.values(object(device, index)).unwrap();
    let count = usize::from(values[0].info.default.as_ref().unwrap()[0]);
    values[1..=count].iter().map(|value| value.info.default.clone().unwrap()).collect()
}

#[test]
fn places_and_objects_are_those_of_the_device() {
    for wired in WIRED {
        let device = &named(wired.family).esi.devices[0];
        let managers: Vec<_> = device.sync_managers.iter().map(|it| it.kind.as_str()).collect();
        assert_eq!(managers, wired.managers, "{}", wired.family);
        let fmmus: Vec<_> = device.fmmus.iter().map(|fmmu| fmmu.kind.as_str()).collect();
        assert_eq!(fmmus, wired.fmmus, "{}", wired.family);
        let pdos = device.rx_pdos.iter().chain(&device.tx_pdos);
        let pdos: Vec<_> = pdos.map(|pdo| (pdo.index, pdo.sync_manager.unwrap())).collect();
        assert_eq!(pdos, wired.pdos, "{}", wired.family);
        assert_eq!(used(device, 0x1C00).concat(), wired.kinds, "{}", wired.family);
        let assignments = device.dictionary.objects.iter().map(|object| object.index);
        let assignments = assignments.filter(|index| (0x1C10..=0x1C1F).contains(index));
        let expected = wired.assignments.iter().map(|(index, _)| *index);
        assert_eq!(assignments.collect::<Vec<_>>(), expected.collect::<Vec<_>>(), "{}", wired.family);
        for (index, pdos) in wired.assignments {
            let pdos: Vec<_> = pdos.iter().map(|pdo| pdo.to_le_bytes().to_vec()).collect();
            assert_eq!(used(device, *index), pdos, "{}: {index:04X}", wired.family);
        }
    }
}

#[test]
fn start_up_lists_write_to_the_assignment_of_the_sync_manager() {
    for wired in WIRED.iter().filter(|wired| wired.family != "without_mailbox") {
        let device = &named(wired.family).family.members[0];
        let writes = device.configurations.iter().flat_map(|it| &it.startup);
        let written = writes.filter(|write| write.address.subindex > 0).map(|write| {
            (write.address.index.0, u16::from_le_bytes(write.data.as_slice().try_into().unwrap()))
        });
        let assigned =
            wired.assignments.iter().flat_map(|(index, pdos)| pdos.iter().map(|pdo| (*index, *pdo)));
        let (mut written, mut assigned): (Vec<_>, Vec<_>) = (written.collect(), assigned.collect());
        written.sort_unstable();
        assigned.sort_unstable();
        assert_eq!(written, assigned, "{}", wired.family);
    }
}

#[test]
fn what_is_on_in_operational_only_says_so() {
    let on = |family: &str| {
        let managers = &named(family).esi.devices[0].sync_managers;
        managers.iter().map(|it| (it.enabled, it.op_only)).collect::<Vec<_>>()
    };
    let (always, op_only) = ((true, false), (true, true));
    assert_eq!(on("without_inputs"), [op_only, always, always]);
    assert_eq!(on("five_managers"), [always, always, always, always, op_only]);
    let sizes = |it: &devc_tests::esi_reader::SyncManager| (it.min_size, it.size, it.max_size);
    let mailbox = &named("without_inputs").esi.devices[0].sync_managers[1];
    assert_eq!(sizes(mailbox), (Some(34), 64, Some(128)));
}

#[test]
fn several_mapping_units_of_a_direction_name_their_sync_manager() {
    for subject in subjects() {
        for (_, device) in subject.devices() {
            for fmmu in &device.fmmus {
                let alike = device.fmmus.iter().filter(|other| other.kind == fmmu.kind).count();
                assert_eq!(fmmu.sync_manager.is_some(), alike > 1, "{}", device.name);
                let kind = fmmu.sync_manager.map(|place| device.sync_managers[place].kind.as_str());
                assert!(kind.is_none_or(|kind| kind == fmmu.kind), "{}", device.name);
            }
        }
    }
}

#[test]
fn sync_managers_are_those_of_the_model_in_their_order() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            assert_eq!(model.sync_managers.len(), read.sync_managers.len());
            for (manager, read) in model.sync_managers.iter().zip(&read.sync_managers) {
                assert_eq!((read.address, read.control), (manager.address, manager.control));
                assert_eq!((read.size, read.max_size), (manager.size, manager.max_size));
                assert_eq!((read.enabled, read.op_only), (manager.enable, manager.op_only));
            }
        }
    }
}

#[test]
fn drives_have_the_usual_four() {
    for family in ["c887", "s700", "pmc-sc6"] {
        for (_, read) in named(family).devices() {
            let kinds: Vec<_> = read.sync_managers.iter().map(|it| it.kind.as_str()).collect();
            assert_eq!(kinds, ["MBoxOut", "MBoxIn", "Outputs", "Inputs"]);
        }
    }
}

#[test]
fn a_sync_manager_is_as_long_as_what_is_assigned_to_it() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            for (place, manager) in read.sync_managers.iter().enumerate() {
                let pdos = match manager.kind.as_str() {
                    "Outputs" => &read.rx_pdos,
                    "Inputs" => &read.tx_pdos,
                    _ => continue,
                };
                let assigned = pdos.iter().filter(|pdo| pdo.sync_manager == Some(place));
                let bits: u32 = assigned.flat_map(|pdo| &pdo.entries).map(|entry| entry.bits).sum();
                assert_eq!(u32::from(manager.size), bits.div_ceil(8));
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
