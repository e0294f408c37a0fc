//! Several sync managers of one direction. Each carries what the object of its number assigns to it, 0x1C10 and up (ETG.1000.6,
//! sync manager PDO assignment): here 0x1C12 and 0x1C13 the outputs, 0x1C14 and 0x1C15 the inputs.

use std::path::Path;

use devc::source::Memory;
use devc_virtual::Subdevice;
use devc_virtual::drive::{Drive, Model};

use crate::devices::Any;
use crate::master::*;
use crate::states::{manager, off, request};

/// What outputs begin with is 9 bytes and 4 bits, so that the gain, which comes by the next sync manager, begins with a byte of
/// its own and not in the middle.
fn bench() -> Bench {
    let text = include_str!("../shared/own.toml")
        .replace(r#"pdos = ["0x1600"] }"#, "pdos = [\"0x1600\"], slots = 2 }\nslow-out = { role = \"outputs\", address = 0x1300, pdos = [\"0x1601\"] }")
        .replace(r#"pdos = ["0x1A00"] }"#, "pdos = [\"0x1A00\"] }\nslow-in = { role = \"inputs\", address = 0x1500, pdos = [\"0x1A01\"] }")
        .replace(r#"access = "rw", default = 5"#, r#"access = "rw", pdo = "rx-tx", default = 5"#)
        .replace(r#""touch-probe-function"]"#, r#""touch-probe-function", { bits = 4 }]"#)
        + "[rx-pdos.0x1601]\nname = \"Gain\"\nentries = [\"0x2000\"]\n[tx-pdos.0x1A01]\nname = \"Gain in use\"\nentries = [\"0x2000\"]\n";
    let memory = Memory::default().with("own/device.toml", text.into_bytes());
    let compilation = devc::compile(&memory, Path::new("own"));
    let family = compilation.family.expect("a description without errors");
    let drive: Any = Box::new(Drive::new(Model::new(&family.members[0])));
    let mut bench = Bench::new(vec![Subdevice::new(drive, Vec::new())]);
    bench.send(APWR, 0, 0x0010, &STATION.to_le_bytes());
    manager(&mut bench, 0, (0x1000, 128), 0x26);
    manager(&mut bench, 1, (0x1080, 128), 0x22);
    assert_eq!(request(&mut bench, 0x02), (0x02, 0), "{:?}", bench.told());
    bench
}

/// Writes one or two bytes by SDO; the abort code if the drive does not take them.
fn download(bench: &mut Bench, index: u16, subindex: u8, data: &[u8]) -> Result<(), u32> {
    let [low, high] = index.to_le_bytes();
    let command = if data.len() == 1 { 0x2F } else { 0x2B };
    let mut message = [0; 128];
    message[..12].copy_from_slice(&[10, 0, 0, 0, 0, 0x03, 0, 0x20, command, low, high, subindex]);
    message[12..12 + data.len()].copy_from_slice(data);
    assert!(bench.write(0x1000, &message));
    let answer: [u8; 128] = bench.read(0x1080).expect("there is an answer");
    match answer[8] {
        0x60 => Ok(()),
        _ => Err(u32::from_le_bytes(answer[12..16].try_into().unwrap())),
    }
}

fn set_managers(bench: &mut Bench) {
    manager(bench, 2, (0x1200, 10), 0x64);
    manager(bench, 3, (0x1300, 2), 0x24);
    manager(bench, 4, (0x1400, 9), 0x20);
    manager(bench, 5, (0x1500, 2), 0x20);
}

#[test]
fn each_carries_what_is_assigned_to_it() {
    let mut bench = bench();
    set_managers(&mut bench);
    assert_eq!(request(&mut bench, 0x04), (0x04, 0), "{:?}", bench.told());
    assert_eq!(bench.read(0x1500), Some([5, 0]), "the gain in use");
    assert!(bench.write(0x1200, &[6, 0, 8, 1, 2, 3, 4, 0, 0, 0]));
    assert_eq!(request(&mut bench, 0x08), (0x14, 0x19), "half of the outputs have come");
    assert!(bench.write(0x1300, &[0x34, 0x12]));
    assert_eq!(request(&mut bench, 0x18), (0x08, 0), "{:?}", bench.told());
    bench.read::<2>(0x1500);
    assert_eq!(bench.read(0x1500), Some([0x34, 0x12]));
    let inputs: [u8; 9] = bench.read(0x1400).expect("there are inputs");
    assert_eq!(inputs[2], 8, "the mode of operation");
    // one alone is new: what the other carried last holds on
    assert!(bench.write(0x1300, &[0x35, 0x12]));
    bench.read::<2>(0x1500);
    assert_eq!(bench.read(0x1500), Some([0x35, 0x12]));
    bench.read::<9>(0x1400);
    let inputs: [u8; 9] = bench.read(0x1400).expect("there are inputs");
    assert_eq!(inputs[2], 8, "the mode of operation");
}

/// ETG.1000.6, AL status codes: 0x1D invalid outputs, 0x1E invalid inputs.
#[test]
fn each_has_to_be_as_long_as_what_it_carries() {
    for (number, address, length, control, code, right) in
        [(3, 0x1300, 1, 0x24, 0x1D, 2), (5, 0x1500, 3, 0x20, 0x1E, 2), (2, 0x1200, 12, 0x64, 0x1D, 10)]
    {
        let mut bench = bench();
        set_managers(&mut bench);
        off(&mut bench, number);
        manager(&mut bench, number, (address, length), control);
        assert_eq!(request(&mut bench, 0x04), (0x12, code));
        let told = bench.told().join("\n");
        let says = format!("; sync manager {number} has {length} bytes instead of {right}");
        assert!(told.ends_with(&says), "{told}");
    }
}

#[test]
fn a_master_moves_pdos_from_one_to_the_other() {
    let mut bench = bench();
    let clear = |bench: &mut Bench, index| assert_eq!(download(bench, index, 0, &[0]), Ok(()));
    clear(&mut bench, 0x1C13);
    assert_eq!(download(&mut bench, 0x1C13, 1, &[0x00, 0x1A]), Err(0x0609_0030), "it goes the other way");
    assert_eq!(download(&mut bench, 0x1C13, 1, &[0x00, 0x16]), Ok(()));
    assert_eq!(download(&mut bench, 0x1C13, 0, &[1]), Err(0x0604_0043), "sync manager 2 carries it");
    assert_eq!(download(&mut bench, 0x1C13, 1, &[0, 0]), Ok(()));
    clear(&mut bench, 0x1C12);
    assert_eq!(download(&mut bench, 0x1C12, 1, &[0x00, 0x16]), Ok(()));
    assert_eq!(download(&mut bench, 0x1C12, 2, &[0x01, 0x16]), Ok(()));
    assert_eq!(download(&mut bench, 0x1C12, 0, &[2]), Ok(()));
    // 9 bytes and 4 bits, and 2 bytes behind them: what nothing is assigned to stays off
    manager(&mut bench, 2, (0x1200, 12), 0x64);
    manager(&mut bench, 4, (0x1400, 9), 0x20);
    manager(&mut bench, 5, (0x1500, 2), 0x20);
    assert_eq!(request(&mut bench, 0x04), (0x04, 0), "{:?}", bench.told());
    assert!(bench.write(0x1200, &[6, 0, 8, 0, 0, 0, 0, 0, 0, 0x70, 0, 0]));
    assert_eq!(request(&mut bench, 0x08), (0x08, 0));
    bench.read::<2>(0x1500);
    assert_eq!(bench.read(0x1500), Some([7, 0]));
}
