//! Sync managers that have other roles than usual: here the mailbox to the master is the first.

use std::path::Path;

use devc::model::{Device, Role};
use devc::source::Memory;
use devc_virtual::Subdevice;
use devc_virtual::drive::{Drive, Model};

use crate::devices::Any;
use crate::master::*;
use crate::states::{manager, request};

fn swapped() -> Device {
    let text = include_str!("../shared/own.toml")
        .replace("mailbox-out = {", "mailbox-out = { number = 1,")
        .replace("mailbox-in  = {", "mailbox-in  = { number = 0,");
    let memory = Memory::default().with("own/device.toml", text.into_bytes());
    let family = devc::compile(&memory, Path::new("own")).family.expect("a description without errors");
    let device = family.members[0].clone();
    assert_eq!(device.sync_manager(Role::MailboxOut).map(|it| it.number), Some(1));
    device
}

fn bench(device: &Device) -> Bench {
    let drive: Any = Box::new(Drive::new(Model::new(device)));
    let mut bench = Bench::new(vec![Subdevice::new(drive, Vec::new())]);
    bench.send(APWR, 0, 0x0010, &STATION.to_le_bytes());
    bench
}

#[test]
fn sync_managers_have_their_roles_by_the_description() {
    let mut bench = bench(&swapped());
    manager(&mut bench, 0, (0x1080, 128), 0x22);
    manager(&mut bench, 1, (0x1000, 128), 0x26);
    assert_eq!(request(&mut bench, 0x02), (0x02, 0), "{:?}", bench.told());
    let mut message = [0; 128];
    message[..11].copy_from_slice(&[10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x40, 0x00, 0x10]);
    assert!(bench.write(0x1000, &message));
    let answer: [u8; 128] = bench.read(0x1080).expect("there is an answer");
    assert_eq!(answer[12..16], 0x0002_0192_u32.to_le_bytes(), "0x1000: the device type");
    // controlword, mode, target, touch probe: 9 bytes; statusword, mode, position, touch probe: 9 bytes
    manager(&mut bench, 2, (0x1200, 9), 0x64);
    manager(&mut bench, 3, (0x1400, 9), 0x20);
    assert_eq!(request(&mut bench, 0x04), (0x04, 0), "{:?}", bench.told());
    assert!(bench.write(0x1200, &[6, 0, 8, 0, 0, 0, 0, 0, 0]));
    assert_eq!(request(&mut bench, 0x08), (0x08, 0));
    let inputs: [u8; 9] = bench.read(0x1400).expect("there are inputs");
    assert_eq!(inputs[2], 8, "the mode of operation");
}

#[test]
fn a_fault_names_the_sync_manager_that_is_to_blame() {
    let mut bench = bench(&swapped());
    manager(&mut bench, 0, (0x1080, 128), 0x22);
    manager(&mut bench, 1, (0x1000, 100), 0x26);
    assert_eq!(request(&mut bench, 0x02), (0x11, 0x16));
    let told = bench.told().join("\n");
    assert!(told.ends_with("; sync manager 1 has 100 bytes instead of 128"), "{told}");
}
