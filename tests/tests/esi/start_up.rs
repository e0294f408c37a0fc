//! What a master does at start-up: commands, timeouts, addresses of Ethernet, units of exchange.

use devc_tests::esi_reader::InitCommand;

use crate::subjects::{corners, named, subjects};

fn command(index: u16, subindex: u8, data: &[u8]) -> InitCommand {
    InitCommand { transition: "PS".to_owned(), address: (index, subindex), data: data.to_vec() }
}

/// The default configuration has mode 8 and 2 ms on both axes: 2 times 10 to the power of -3 s (CiA 402). Another
/// configuration is not in the file, nor are assignments, which masters write by themselves.
#[test]
fn the_commands_are_those_of_the_default_configuration() {
    let axis = |by: u16| {
        [
            command(0x6060 + by, 0, &[8]),
            command(0x60C2 + by, 1, &[2]),
            command(0x60C2 + by, 2, &(-3_i8).to_le_bytes()),
        ]
    };
    let expected: Vec<_> = axis(0).into_iter().chain(axis(0x800)).collect();
    assert_eq!(corners().esi.devices[0].init_commands, expected);
    // As delivered, the C-887 runs in cycles of 1 ms (p. 4); it takes its mode with the process data.
    let c887 = &named("c887").esi.devices[0].init_commands;
    assert!(c887.iter().all(|command| command.address.0 & 0x7FF == 0x60C2 & 0x7FF), "{c887:X?}");
}

#[test]
fn commands_write_what_the_dictionary_lets_be_written_in_its_width() {
    let mut seen = 0;
    for subject in subjects() {
        for (_, device) in subject.devices() {
            for InitCommand { transition, address: (index, subindex), data } in &device.init_commands {
                let object = device.dictionary.objects.iter().find(|object| object.index == *index).unwrap();
                let values = device.dictionary.values(object).unwrap();
                let value = values.iter().find(|value| value.subindex == *subindex).unwrap();
                assert_ne!(value.flags.access, "ro", "{index:04X}:{subindex}");
                assert_eq!(value.bits as usize, data.len() * 8, "{index:04X}:{subindex}");
                assert!(["IP", "PS", "SO", "SP", "OP", "OS"].contains(&transition.as_str()));
                seen += 1;
            }
        }
    }
    assert!(seen > 6, "{seen} commands");
}

#[test]
fn timeouts_are_in_milliseconds() {
    let timeouts = corners().esi.devices[0].timeouts.iter().map(|(name, time)| (name.as_str(), *time));
    let expected = [
        ("PreopTimeout", 3000),
        ("SafeopOpTimeout", 9000),
        ("BackToInitTimeout", 5000),
        ("BackToSafeopTimeout", 200),
        ("RequestTimeout", 100),
        ("ResponseTimeout", 2000),
    ];
    assert_eq!(timeouts.collect::<Vec<_>>(), expected);
}

#[test]
fn what_nobody_states_is_not_there() {
    let silent = subjects().iter().filter(|it| !["corners", "sv660n"].contains(&&*it.family.id));
    for subject in silent {
        for (_, device) in subject.devices() {
            assert!(device.timeouts.is_empty() && device.sync_units.is_empty() && device.hidden.is_empty());
            assert_eq!(device.eoe, (None, None));
        }
    }
}

#[test]
fn units_of_exchange_ethernet_and_revisions_are_as_stated() {
    let device = &corners().esi.devices[0];
    assert_eq!(device.sync_units, ["Slow", "Fast"]);
    let unit = |index: u16| {
        let mut pdos = device.rx_pdos.iter().chain(&device.tx_pdos);
        pdos.find(|pdo| pdo.index == index).unwrap().sync_unit.map(|unit| device.sync_units[unit].as_str())
    };
    assert_eq!((unit(0x16FF), unit(0x1A00), unit(0x1600)), (Some("Slow"), Some("Fast"), None));
    assert_eq!(device.eoe, (Some(1), Some(0)));
    assert_eq!(device.hidden, [0x0001_0000, 0x0001_0001]);
}
