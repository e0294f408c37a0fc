//! What devc makes of a choice of process data, on the PMC SC6: a mapping is repeated on every axis, and the
//! start-up list has nothing that the mailbox refuses.

#![allow(clippy::expect_used)] // a test may

use std::path::Path;

use devc::model::{Configuration, Index};
use devc::source::Disk;

/// A configuration of a member of the PMC SC6.
fn configuration(member: &str, id: &str) -> Configuration {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices/pmc-sc6");
    let family = devc::compile(&Disk, &folder).family.expect("it compiles");
    let mut members = family.members.iter();
    let device = members.find(|device| device.id == member).expect("there is this member");
    device.configurations.iter().find(|c| c.id == id).expect("there is this configuration").clone()
}

/// Index and bytes of each PDO that is mapped anew.
fn sizes(configuration: &Configuration) -> Vec<(u16, u32)> {
    let bits = |pdo: &devc::model::Pdo| pdo.entries.iter().map(|entry| entry.bits).sum::<u32>();
    configuration.mapping.iter().map(|pdo| (pdo.index.0, bits(pdo) / 8)).collect()
}

#[test]
fn a_mapping_holds_on_every_axis() {
    let on_two = configuration("double", "interpolated-position");
    assert_eq!(sizes(&on_two), [(0x1600, 7), (0x1601, 7), (0x1A00, 7), (0x1A01, 7)]);
    let on_one = configuration("single", "velocity");
    assert_eq!(sizes(&on_one), [(0x1600, 5), (0x1A00, 5)]);
}

#[test]
fn an_entry_is_that_of_its_axis() {
    let velocity = configuration("double", "velocity");
    let of = |index| velocity.mapping.iter().find(|pdo| pdo.index == Index(index)).expect("it is mapped");
    let indices =
        |index| of(index).entries.iter().map(|e| e.address.map_or(0, |a| a.index.0)).collect::<Vec<_>>();
    assert_eq!(indices(0x1600), [0x6040, 0x6060, 0x6042]);
    assert_eq!(indices(0x1601), [0x6840, 0x6860, 0x6842]);
}

#[test]
fn what_the_mailbox_refuses_is_not_in_the_list() {
    let velocity = configuration("double", "velocity");
    let writes: Vec<_> = velocity.startup.iter().map(|w| (w.address.index.0, &w.data[..])).collect();
    assert_eq!(writes, [(0x6060, &[2][..]), (0x6860, &[2][..])]);
}

/// How many subindices the mapping object of a PDO has, and how many of them are in use.
fn capacity(folder: &str, member: &str, index: u16) -> (usize, usize) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(folder);
    let family = devc::compile(&Disk, &folder).family.expect("it compiles");
    let mut members = family.members.iter();
    let device = members.find(|device| device.id == member).expect("there is this member");
    let object = device.object(Index(index)).expect("each PDO has one");
    let count = object.entry(0).and_then(|count| count.default.as_ref());
    let used = count.and_then(devc::model::Value::integer);
    (object.entries.len() - 1, used.expect("it is a number").try_into().expect("it is small"))
}

/// 24 elements of A225 and A233 (Pilz, 7.1.1 and 7.1.2); the S700's manual names the bytes only, 64, and the
/// mapping of the C-887 is fixed.
#[test]
fn a_mapping_object_has_the_subindices_that_the_device_takes() {
    assert_eq!(capacity("pmc-sc6", "double", 0x1600), (24, 8));
    assert_eq!(capacity("pmc-sc6", "double", 0x1A01), (24, 10));
    assert_eq!(capacity("s700", "s700", 0x1701), (2, 2));
    let (free, used) = capacity("s700", "s700", 0x1600);
    assert!(used == 1 && (16..=64).contains(&free), "{free} entries of at most 64 bytes");
    assert_eq!(capacity("c887", "c887", 0x1600), (3, 3));
}
