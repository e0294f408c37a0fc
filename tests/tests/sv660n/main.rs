//! A drive that devc does not ship, described from public material alone: what its sources say, fact by fact, and what
//! follows from the description.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

use std::path::Path;
use std::sync::LazyLock;

use devc::lint::Checked;
use devc::model::{Address, Device, Direction, Entry, Family, Index, Role, Value};
use devc::source::Disk;

fn device() -> &'static Device {
    static FAMILY: LazyLock<Checked<Family>> = LazyLock::new(|| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("devices/sv660n");
        let compilation = devc::compile(&Disk, &folder);
        let messages: Vec<_> = compilation.diagnostics.iter().map(|it| it.message.as_str()).collect();
        assert!(messages.is_empty(), "{messages:#?}");
        compilation.family.expect("it has no errors")
    });
    FAMILY.members.first().expect("there is a device")
}

fn entry(index: u16, subindex: u8) -> &'static Entry {
    device().entry(Address { index: Index(index), subindex }).expect("it is described")
}

fn default(index: u16, subindex: u8) -> Option<i128> {
    entry(index, subindex).default.as_ref().and_then(Value::integer)
}

/// Entries of a range of the dictionary that the file describes; subindex 0 of several counts them.
fn described(first: u16, last: u16) -> usize {
    let objects = device().objects.iter().filter(|object| (first..=last).contains(&object.index.0));
    objects.map(|object| if object.entries.len() == 1 { 1 } else { object.entries.len() - 1 }).sum()
}

#[test]
fn it_is_described_whole() {
    // the file: 4 + 9 + 26 + 15 + 7 + 15 + 11 + 19 + 40 + 42 + 34 + 55 + 11 + 19 + 1
    assert_eq!(described(0x2000, 0x2FFF), 308);
    // 60 of one value, 2 of each 0x607D, 0x6091, 0x6099 and 0x60FE, and 31 of 0x60E3
    assert_eq!(described(0x6000, 0x6FFF), 60 + 4 * 2 + 31);
}

/// 0x6502 is 0x3AD by the file: bits 0, 2, 3, 5, 7, 8 and 9.
#[test]
fn its_modes_are_those_that_it_says() {
    let codes: Vec<i16> = device().modes.iter().map(|mode| mode.code).collect();
    assert_eq!(codes, [1, 3, 4, 6, 8, 9, 10]);
    let bits = device().modes.iter().filter_map(|mode| mode.supported_bit).fold(0, |all, bit| all | 1 << bit);
    assert_eq!((default(0x6502, 0), bits), (Some(0x3AD), 0x3AD));
}

/// The parameter Hgg-oo is index 0x20gg, subindex oo + 1.
#[test]
fn its_parameters_have_their_numbers() {
    for (index, subindex, parameter, name) in [
        (0x2002, 1, "H02-00", "Control mode selection"),
        (0x2005, 31, "H05-30", "Local home mode"),
        (0x200A, 11, "H0A-10", "Local following error window"),
        (0x200E, 97, "H0E-96", "EtherCAT xml file version number"),
        (0x2003, 65, "H03-64", "DI5 filtertime constant"),
    ] {
        let entry = entry(index, subindex);
        assert_eq!((entry.parameter.as_deref(), &*entry.name), (Some(parameter), name));
    }
    assert!(entry(0x2002, 0).parameter.is_none());
}

#[test]
fn defaults_that_count_are_counted() {
    for method in 1..=31 {
        assert_eq!(default(0x60E3, method), Some(0x300 + i128::from(method)));
        assert_eq!(entry(0x60E3, method).name, format!("Support homing method {method}"));
    }
}

/// The profile has several values at 0x60E6, and the drive one.
#[test]
fn an_object_can_be_another_one_than_in_the_profile() {
    let object = device().object(Index(0x60E6)).expect("it is described");
    let types: Vec<String> = object.entries.iter().map(|entry| entry.data_type.to_string()).collect();
    assert_eq!(types, ["INT8"]);
}

/// `DefaultSize` of the file's third and fourth `Sm`.
#[test]
fn its_process_data_has_the_size_of_the_file() {
    let bytes = |way| {
        let assigned = device().assigned(Role::of(way));
        assigned.flat_map(|pdo| &pdo.entries).map(|entry| entry.bits).sum::<u32>() / 8
    };
    assert_eq!((bytes(Direction::Rx), bytes(Direction::Tx)), (12, 28));
    let start: Vec<_> = device().configurations.iter().flat_map(|it| &it.startup).collect();
    let start: Vec<_> =
        start.iter().map(|write| (&*write.transition, write.address.index.0, &write.data[..])).collect();
    assert_eq!(start, [("PS", 0x6060, &[8][..])]);
}

/// The table of the guide: 0x1101 is shown as E101.1, and what has type 3 is a warning, which can be reset.
#[test]
fn its_faults_are_those_of_the_guide() {
    let codes = &device().vendor_codes;
    assert_eq!(codes.len(), 108);
    for code in codes {
        let shown = format!("E{:03X}.{:X}", code.code & 0xFFF, code.code >> 12);
        assert_eq!(code.panel.as_deref(), Some(&*shown));
        assert!(matches!(code.severity.as_deref(), Some("1" | "2" | "3")), "{shown}");
        assert!(code.severity.as_deref() == Some("1") || code.resettable == Some(true), "{shown}");
    }
    let final_ones = codes.iter().filter(|code| code.resettable == Some(false)).count();
    assert_eq!(final_ones, 29);
}
