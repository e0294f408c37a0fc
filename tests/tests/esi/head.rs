//! What stands before and beside the dictionary: identity, groups, mailbox, clocks, EEPROM, assumptions.

use devc::model::{Section, SyncSignal};
use devc_tests::esi_reader::Signal;

use crate::subjects::{named, subjects};

#[test]
fn vendor_and_groups_are_those_of_the_model() {
    for subject in subjects() {
        let first = &subject.family.members[0];
        assert_eq!(subject.esi.version, "1.14");
        assert_eq!(subject.esi.vendor_id, first.identity.vendor_id);
        assert_eq!(subject.esi.vendor_name, first.vendor);
        for device in &subject.family.members {
            let groups = subject.esi.groups.iter().filter(|(kind, _)| *kind == device.group);
            assert_eq!(groups.map(|(_, name)| name.as_str()).collect::<Vec<_>>(), [device.group.as_str()]);
        }
    }
}

#[test]
fn identity_is_that_of_the_model() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            assert_eq!(read.type_name, model.type_name);
            assert_eq!(read.product_code, model.identity.product_code);
            assert_eq!(read.revision, model.identity.revision);
            assert_eq!(read.physics, model.physics);
            assert_eq!(read.group, model.group);
            assert!(read.name.starts_with(&model.name), "{} is not {}", read.name, model.name);
        }
    }
}

#[test]
fn each_axis_is_a_channel_of_the_profile() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let named = |axis: &devc::model::Axis| (!axis.name.is_empty()).then(|| axis.name.clone());
            let axes = model.axes.iter().filter_map(|axis| Some((model.profile?, named(axis))));
            assert_eq!(read.profile.0, model.profile);
            let channels = read.channels.iter().map(|(number, _, name)| (*number, name.clone()));
            assert_eq!(channels.collect::<Vec<_>>(), axes.collect::<Vec<_>>());
        }
    }
}

/// The upper half of the device type is 2 for a servo drive (CiA 402) and 0xFFFF for several axes (CiA 301); that is
/// no type of an axis.
#[test]
fn each_channel_of_a_servo_drive_says_that_it_is_one() {
    for family in ["c887", "s700", "pmc-sc6"] {
        for (_, read) in named(family).devices() {
            assert!(!read.channels.is_empty(), "{family}");
            assert!(read.channels.iter().all(|(_, information, _)| *information == Some(2)), "{family}");
        }
    }
}

#[test]
fn name_and_title_are_parted_by_a_colon() {
    let names = |family| named(family).devices().map(|(_, read)| read.name.clone()).collect::<Vec<_>>();
    assert_eq!(names("c887"), ["C-887.53x: Hexapod controller with EtherCAT interface"]);
    assert_eq!(names("without_outputs"), ["Sensor"], "no title, no colon");
}

#[test]
fn the_device_type_consists_of_the_profile_and_its_additional_information() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let Some(object) = read.dictionary.objects.iter().find(|object| object.index == 0x1000) else {
                continue;
            };
            let Some([low, high, more, most]) = object.info.default.as_deref() else { continue };
            let profile = u32::from(*low) | u32::from(*high) << 8;
            let information = u32::from(*more) | u32::from(*most) << 8;
            // 0 stands for a device without a profile, ETG.1000.6.
            let stated = if profile == 0 { (None, None) } else { (Some(profile), Some(information)) };
            assert_eq!(read.profile, stated, "{}", model.name);
        }
    }
}

#[test]
fn the_mailbox_can_do_what_the_model_says() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let Some(mailbox) = &model.mailbox else {
                assert!(read.protocols.is_empty());
                continue;
            };
            let mut spoken: Vec<&str> = mailbox.protocols.iter().map(|protocol| protocol.name()).collect();
            spoken.sort_by_key(|name| {
                ["AoE", "EoE", "CoE", "FoE", "SoE", "VoE"].iter().position(|it| it == name)
            });
            assert_eq!(read.protocols, spoken);
            let coe = read.coe.as_ref().unwrap();
            assert_eq!(coe.sdo_info, mailbox.sdo_info);
            assert_eq!(coe.pdo_assign, mailbox.pdo_assign);
            assert_eq!(coe.pdo_config, mailbox.pdo_config);
            assert_eq!(coe.complete_access, mailbox.complete_access);
            assert_eq!(coe.segmented, mailbox.segmented);
        }
    }
}

#[test]
fn the_ways_to_keep_time_are_those_of_the_model() {
    let same = |model: &Option<SyncSignal>, read: &Option<Signal>| match (model, read) {
        (None, None) => true,
        (Some(model), Some(read)) => model.shift.0 == i64::from(read.shift),
        _ => false,
    };
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let clocked = model.sync_modes.iter().any(|mode| mode.assign_activate != 0);
            let modes = if clocked { model.sync_modes.as_slice() } else { &[] };
            assert_eq!(read.op_modes.len(), modes.len());
            for (mode, read) in modes.iter().zip(&read.op_modes) {
                assert_eq!(read.name, mode.id);
                assert_eq!(read.description.as_deref(), Some(mode.name.as_str()));
                assert_eq!(read.assign_activate, mode.assign_activate);
                assert!(same(&mode.sync0, &read.sync0), "{}: {:?} {:?}", mode.id, mode.sync0, read.sync0);
                assert!(same(&mode.sync1, &read.sync1), "{}: {:?} {:?}", mode.id, mode.sync1, read.sync1);
            }
            let default = model.sync_modes.iter().find(|mode| mode.default);
            assert!(
                default.is_none_or(|default| read.op_modes.first().is_none_or(|it| it.name == default.id))
            );
        }
    }
}

/// ETG.2000: `Factor` counts cycles of the master, below 0 the signals in one; a time of its own has none.
#[test]
fn signals_come_when_they_are_said_to() {
    let modes = &named("corners").esi.devices[0].op_modes;
    let signals = |name: &str| {
        let mode = modes.iter().find(|mode| mode.name == name).unwrap();
        [&mode.sync0, &mode.sync1].map(|signal| {
            signal.as_ref().map(|it| (it.period, it.factor, it.shift, it.shift_factor, it.input))
        })
    };
    let both = [Some((0, Some(1), 20_000, None, false)), Some((0, Some(-2), 0, None, false))];
    assert_eq!(signals("both"), both);
    let fixed = [Some((250_000, None, -20_000, None, false)), Some((0, Some(3), 0, Some(1), true))];
    assert_eq!(signals("fixed"), fixed);
    assert_eq!(signals("free-run"), [None, None], "the clocks stand still");
}

#[test]
fn the_eeprom_is_that_of_the_description() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let written = read.eeprom.as_ref().map(|it| (it.size, it.config_data.clone()));
            let described = Some((model.eeprom.size, model.eeprom.config_data.0.clone()));
            assert_eq!(written, described.filter(|_| model.eeprom.is_described()));
        }
    }
    let first = |family: &str| named(family).esi.devices[0].eeprom.as_ref().map(|it| it.config_data.clone());
    assert_eq!(first("s700"), Some(vec![0x09, 0, 0, 0x08, 0, 0]), "as two siblings have it");
    assert_eq!(first("c887"), Some(Vec::new()), "nobody knows them, and a guess would do harm");
    assert_eq!(first("without_mailbox"), None, "nothing is said of it");
}

/// ETG.1000.6 makes 0x1018 repeat what the EEPROM has; CiA 301 has 0xFFFF in the device type of several axes.
#[test]
fn what_one_section_states_the_dictionary_repeats() {
    let device = &named("corners").esi.devices[0];
    let defaults = |index: u16| {
        let object = device.dictionary.objects.iter().find(|object| object.index == index).unwrap();
        let values = device.dictionary.values(object).unwrap();
        values.iter().map(|value| value.info.default.clone()).collect::<Vec<_>>()
    };
    let number = |value: u32| Some(value.to_le_bytes().to_vec());
    let identity = [number(device_vendor()), number(device.product_code), number(device.revision), None];
    assert_eq!(defaults(0x1018)[1..], identity);
    assert_eq!(defaults(0x1008), [Some(b"Corner 1".to_vec())]);
    let sensor = &named("without_outputs").esi.devices[0].dictionary;
    let name = sensor.objects.iter().find(|object| object.index == 0x1008).unwrap();
    assert_eq!((name.bits, name.info.default.clone()), (48, Some(b"Sensor".to_vec())));
}

fn device_vendor() -> u32 {
    named("corners").esi.vendor_id
}

/// What an ESI has elements for (ETG.2000): identity, mailbox and clocks whole, of a sync manager all but how many PDOs it
/// takes. It has none for what a drive does: words, states, modes, errors.
#[test]
fn what_is_assumed_can_be_read_at_the_head_if_the_file_has_it() {
    let whole = [Section::Identity, Section::Mailbox];
    let never = [
        Section::Words,
        Section::States,
        Section::Commands,
        Section::Transitions,
        Section::Modes,
        Section::Errors,
        Section::Registers,
        Section::Leds,
        Section::Limits,
    ];
    let (mut seen, mut left_out, mut units) = (0, 0, 0);
    for subject in subjects() {
        let head = subject.xml.split("<EtherCATInfo").next().unwrap();
        for assumption in subject.family.members.iter().flat_map(|device| &device.assumptions) {
            // A comment cannot hold two hyphens in a row.
            let reason =
                assumption.reason.split_whitespace().collect::<Vec<_>>().join(" ").replace("--", "- -");
            let at = &assumption.at;
            let manager = at.section == Section::SyncManagers && at.path.as_deref() != Some("slots");
            if whole.contains(&at.section) || manager {
                assert!(head.contains(&at.to_string()) && head.contains(&reason), "{at} is not at the head");
                seen += 1;
            }
            // The unit of a value, where it has a code: an element of its object.
            if let (Section::Objects, Some("unit")) = (at.section, at.path.as_deref()) {
                let index = at.to_string().replace("0x", "#x").replace(".unit", "");
                let object = subject.xml.split("<Object").find(|it| it.contains(&format!("<Index>{index}<")));
                let has_unit = object.is_some_and(|object| object.contains("<Unit>"));
                assert_eq!(head.contains(&format!("- {at}")), has_unit, "{at}");
                units += 1;
            }
            if never.contains(&at.section) {
                assert!(!head.contains(&format!("- {at}")), "{at} is at the head");
                left_out += 1;
            }
        }
    }
    assert!(seen > 10 && left_out > 10 && units > 3, "{seen} seen, {left_out} left out, {units} units");
}

#[test]
fn the_file_is_utf8_with_two_spaces_a_level_and_nothing_else() {
    for subject in subjects() {
        assert!(subject.xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!--"));
        assert!(subject.xml.ends_with("</EtherCATInfo>\n"));
        assert!(!subject.xml.contains(['\r', '\t', '\u{FEFF}']));
        assert!(subject.xml.lines().all(|line| line == line.trim_end()), "spaces at the end of a line");
    }
}
