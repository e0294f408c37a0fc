//! Entries that are orders: parameters that are stored (CiA 301, 0x1010 and 0x1011), and triggers of descriptions.

use devc::model::{Address, Index};
use devc_runtime::sdo::AbortCode;
use devc_virtual::Firmware;
use devc_virtual::drive::{Drive, Stored};

use crate::bench::{Bench, PRE_OP, device};
use crate::shared::model;

const fn at(index: u16, subindex: u8) -> Address {
    Address { index: Index(index), subindex }
}

const GAIN: Address = at(0x2000, 0);
const WINDOW: Address = at(0x6065, 0);
const SAVE: &[u8] = b"save";
const LOAD: &[u8] = b"load";

fn pre_operational(drive: Option<Drive>) -> Bench {
    let mut bench = Bench::new(device("own"), None);
    if let Some(drive) = drive {
        bench.drive = drive;
    }
    bench.request(PRE_OP).expect("nothing is wrong");
    bench
}

/// Off and on again.
fn cycled(mut bench: Bench) -> Bench {
    bench.drive.power_cycle();
    pre_operational(Some(bench.drive))
}

fn values(bench: &mut Bench) -> [Result<Vec<u8>, AbortCode>; 2] {
    [GAIN, WINDOW].map(|address| bench.upload(address))
}

#[test]
fn what_is_stored_is_there_after_a_power_cycle() {
    // all; communication, application, manufacturer: and what of gain and window each stores
    for (group, stored) in [(1, [true, true]), (2, [false, false]), (3, [false, true]), (4, [true, false])] {
        let mut bench = pre_operational(None);
        bench.download(GAIN, &[9, 0]).expect("it can be written");
        bench.download(WINDOW, &[1, 2, 0, 0]).expect("it can be written");
        bench.download(at(0x1010, group), SAVE).expect("the signature is right");
        bench.cycle();
        bench.download(GAIN, &[77, 0]).expect("this is not stored");
        let mut bench = cycled(bench);
        let expected = [[&[5, 0][..], &[9, 0]], [&[0xFF; 4], &[1, 2, 0, 0]]];
        for ((read, is_stored), expected) in values(&mut bench).into_iter().zip(stored).zip(expected) {
            assert_eq!(read.expect("it can be read"), expected[usize::from(is_stored)], "group {group}");
        }
        // what is restored counts from the next start
        bench.download(at(0x1011, 1), LOAD).expect("the signature is right");
        bench.cycle();
        assert_eq!(bench.upload(GAIN), Ok(if stored[0] { vec![9, 0] } else { vec![5, 0] }));
        let mut bench = cycled(bench);
        assert_eq!(values(&mut bench), [Ok(vec![5, 0]), Ok(vec![0xFF; 4])]);
    }
}

#[test]
fn without_the_signature_nothing_is_stored() {
    for (entry, wrong) in [(at(0x1010, 1), b"load"), (at(0x1010, 1), b"evas"), (at(0x1011, 1), b"save")] {
        let mut bench = pre_operational(None);
        bench.download(GAIN, &[9, 0]).expect("it can be written");
        // CiA 301: data cannot be transferred or stored to the application
        assert_eq!(bench.download(entry, wrong), Err(AbortCode(0x0800_0020)));
        bench.cycle();
        assert_eq!(values(&mut cycled(bench))[0], Ok(vec![5, 0]));
    }
}

#[test]
fn a_read_tells_how_the_device_stores() {
    let mut bench = pre_operational(None);
    for (entry, order) in [(at(0x1010, 1), SAVE), (at(0x1011, 1), LOAD)] {
        bench.download(entry, order).expect("the signature is right");
        // bit 0 of the description: on command
        assert_eq!(bench.upload(entry), Ok(vec![1, 0, 0, 0]));
    }
    bench.cycle();
    let told: Vec<String> = bench.drive.take_events().iter().map(ToString::to_string).collect();
    assert_eq!(told, ["stores parameters", "restores parameters, with effect after a power cycle"]);
}

/// A program keeps them in a file, and gives them to the drive when it starts.
#[test]
fn stored_values_can_be_kept_elsewhere() {
    let mut bench = pre_operational(None);
    bench.download(GAIN, &[9, 0]).expect("it can be written");
    bench.download(at(0x1010, 1), SAVE).expect("the signature is right");
    bench.cycle();
    let stored: Stored = bench.drive.stored().clone();
    let mut bench = pre_operational(Some(Drive::with_stored(model(device("own")), stored)));
    assert_eq!(values(&mut bench)[0], Ok(vec![9, 0]));
    // what cannot be stored is not taken, nor is what there is not; a value that is too short changes what it has
    let address = |index| devc_runtime::object::Address::new(index, 0);
    let wild = [(address(0x6041), vec![9; 2]), (address(0x5555), vec![1]), (address(0x2000), vec![8])];
    let mut bench = pre_operational(Some(Drive::with_stored(model(device("own")), wild.into())));
    assert_eq!(values(&mut bench)[0], Ok(vec![8, 0]));
}

#[test]
fn process_data_is_not_stored() {
    let mut bench = Bench::operational(device("own"));
    bench.command(0x06);
    assert_eq!(bench.drive.read(devc_runtime::object::Address::new(0x6040, 0)), Some(0x06));
    bench.download(at(0x1010, 1), SAVE).expect("the signature is right");
    bench.cycle();
    let mut bench = cycled(bench);
    assert_eq!(bench.upload(at(0x6040, 0)), Ok(vec![0, 0]), "a drive does not start by itself");
}

/// C-887, p. 18 and p. 25: in mode 0 only; 0x5010:04 resets the error codes.
#[test]
fn triggers_act_in_the_mode_that_they_need() {
    let mut bench = Bench::operational(device("c887"));
    bench.enable();
    let work = at(0x5010, 1);
    bench.select(8);
    // CiA 301: because of the present device state
    assert_eq!(bench.download(work, &[1, 0, 0, 0]), Err(AbortCode(0x0800_0022)));
    assert_eq!(bench.download(work, &[2, 0, 0, 0]), Ok(()), "another value sets off nothing");
    bench.select(0);
    bench.drive.take_events();
    assert_eq!(bench.download(work, &[1, 0, 0, 0]), Ok(()));
    bench.cycle();
    let told: Vec<String> = bench.drive.take_events().iter().map(ToString::to_string).collect();
    let expected =
        "0x5010:01 sets off: activate the work coordinate system, which changes the position of all axes";
    assert_eq!(told, [expected]);
    bench.drive.fault(2, 0x7305);
    bench.cycles(20);
    assert_ne!(bench.get(at(0x1001, 0)), 0);
    assert_eq!(bench.download(at(0x5010, 4), &[1, 0, 0, 0]), Ok(()));
    bench.cycle();
    assert_eq!([bench.get(at(0x1001, 0)), bench.get(bench.on(2, 0x603F, 0))], [0, 0]);
}
