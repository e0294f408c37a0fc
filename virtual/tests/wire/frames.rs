//! Commands, addressing and working counters, against the tables of ETG.1000.4, DLPDU.

use crate::devices::{all, c887};
use crate::master::*;

/// Two devices, with stations 0x1001 and 0x1002.
fn two() -> Bench {
    let mut devices = all().into_iter();
    let mut bench = Bench::new(devices.by_ref().take(2).map(crate::devices::Device::subdevice).collect());
    for (position, station) in [(0_u16, 0x1001_u16), (1, 0x1002)] {
        let answer = bench.send(APWR, position.wrapping_neg(), 0x0010, &station.to_le_bytes());
        assert_eq!(answer.counter, 1);
    }
    bench
}

/// Memory of user data, which every command may read and write: each with what comes back and how it is counted.
#[test]
fn each_command_is_counted_as_the_standard_says() {
    let user = 0x0F80;
    let second = 1_u16.wrapping_neg();
    // command, address, working counter, data that come back, data of both devices afterwards
    let cases: [(u8, u16, u16, u8, [u8; 2]); 15] = [
        (0, 0x1001, 0, 0x40, [0x01, 0x02]),
        (APRD, second, 1, 0x02, [0x01, 0x02]),
        (APWR, second, 1, 0x40, [0x01, 0x40]),
        (APRW, second, 3, 0x02, [0x01, 0x40]),
        (FPRD, 0x1001, 1, 0x01, [0x01, 0x02]),
        (FPWR, 0x1001, 1, 0x40, [0x40, 0x02]),
        (FPRW, 0x1001, 3, 0x01, [0x40, 0x02]),
        (BRD, 0, 2, 0x43, [0x01, 0x02]),
        (BWR, 0, 2, 0x40, [0x40, 0x40]),
        (BRW, 0, 6, 0x43, [0x40, 0x41]),
        (ARMW, 0, 2, 0x01, [0x01, 0x01]),
        (FRMW, 0x1001, 2, 0x01, [0x01, 0x01]),
        (FPRD, 0x1003, 0, 0x40, [0x01, 0x02]),
        (APWR, 2_u16.wrapping_neg(), 0, 0x40, [0x01, 0x02]),
        (15, 0x1001, 0, 0x40, [0x01, 0x02]),
    ];
    for (command, address, counter, back, after) in cases {
        let mut bench = two();
        bench.send(FPWR, 0x1001, user, &[0x01]);
        bench.send(FPWR, 0x1002, user, &[0x02]);
        let answer = bench.send(command, address, user, &[0x40]);
        assert_eq!((answer.counter, answer.data[0]), (counter, back), "command {command}");
        let [first, second] = [0x1001, 0x1002].map(|station| bench.send(FPRD, station, user, &[0]).data[0]);
        assert_eq!([first, second], after, "command {command}");
    }
}

/// The position is counted up by each device, for a master to see how many there are.
#[test]
fn positions_are_counted_on_the_way() {
    for (command, is_counted) in [(APRD, true), (BRD, true), (ARMW, true), (FPRD, false), (0, false)] {
        let answer = two().send(command, 5, 0x0F80, &[0]);
        let [low, high, ..] = answer.address;
        let expected = if is_counted { 7 } else { 5 };
        assert_eq!(u16::from_le_bytes([low, high]), expected, "command {command}");
    }
}

#[test]
fn all_datagrams_of_a_frame_are_served() {
    let mut bench = two();
    let datagrams: Vec<_> =
        (0..15_u8).map(|n| Datagram::new(FPWR, 0x1001, 0x0F80 + u16::from(n), &[n])).collect();
    let counters: Vec<_> = bench.all(&datagrams).iter().map(|answer| answer.counter).collect();
    assert_eq!(counters, [1; 15]);
    let expected: Vec<u8> = (0..15).collect();
    assert_eq!(bench.send(FPRD, 0x1001, 0x0F80, &[0; 15]).data, expected);
}

#[test]
fn a_tag_of_a_vlan_is_passed_over() {
    let mut bench = two();
    let plain = frame(&[Datagram::new(BRD, 0, 0x0000, &[0])]);
    let mut tagged = plain[..12].to_vec();
    tagged.extend([0x81, 0x00, 0x00, 0x05]);
    tagged.extend(&plain[12..]);
    assert!(bench.wire.pass(&mut tagged));
    assert_eq!(tagged[31..33], [2, 0], "both have counted");
}

#[test]
fn the_alias_is_an_address_if_the_master_says_so() {
    let mut bench = Bench::of(c887());
    assert_eq!(bench.read(0x0012), Some([0x23, 0x01]), "from the EEPROM");
    assert_eq!(bench.send(FPRD, 0x0123, 0x0000, &[0]).counter, 0);
    assert!(bench.write(0x0103, &[0x01]));
    assert_eq!(bench.send(FPRD, 0x0123, 0x0000, &[0]).counter, 1);
    assert_eq!(bench.send(FPRD, STATION, 0x0000, &[0]).counter, 1);
}

#[test]
fn what_masters_read_first_is_there() {
    let mut bench = two();
    // FMMUs, sync managers, and that there are 64-bit clocks
    let [fmmus, managers, ram] = bench.read::<3>(0x0004).unwrap();
    assert_eq!([fmmus, managers, ram], [8, 8, 8]);
    assert_eq!(bench.read::<2>(0x0008).unwrap()[0] & 0x0C, 0x0C);
    // the first has another one behind it: communication at ports 0 and 1; the last at port 0 only
    let status = |bench: &mut Bench, station| bench.send(FPRD, station, 0x0110, &[0; 2]).data;
    let (first, last) = (status(&mut bench, 0x1001), status(&mut bench, 0x1002));
    assert_eq!((first[0] & 0x30, first[1] & 0x0F), (0x30, 0x0A));
    assert_eq!((last[0] & 0x30, last[1] & 0x0F), (0x10, 0x06));
}

#[test]
fn what_is_the_devices_is_not_written() {
    let mut bench = Bench::of(c887());
    for register in [0x0000, 0x0012, 0x0110, 0x0130, 0x0134, 0x0805, 0x0807, 0x092C] {
        let before = bench.read::<1>(register).unwrap();
        assert!(!bench.write(register, &[0xA5]), "0x{register:04X}");
        assert_eq!(bench.read::<1>(register), Some(before));
    }
    assert!(bench.told().iter().any(|event| event.contains("register 0x0130")));
    // of a range, what can be written is
    assert!(bench.write(0x0010, &[0x01, 0x10, 0xFF, 0xFF]));
    assert_eq!(bench.read(0x0010), Some([0x01, 0x10, 0x23, 0x01]));
}

#[test]
fn memory_ends_somewhere() {
    let mut bench = Bench::of(c887());
    assert!(bench.write(0x2FFF, &[1]));
    assert!(!bench.write(0x3000, &[1]));
    assert_eq!(bench.read::<1>(0xFFFF), None);
}

#[test]
fn events_are_told_in_the_frame() {
    let mut bench = Bench::of(c887());
    assert_eq!(bench.send(FPRD, STATION, 0, &[0]).interrupt, 0);
    bench.write(0x0200, &0x0020_u16.to_le_bytes());
    crate::states::to_pre_operational(&mut bench);
    assert_eq!(bench.send(FPRD, STATION, 0, &[0]).interrupt, 0);
    let mut message = vec![0; 128];
    message[..10].copy_from_slice(&[10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x40, 0x00]);
    message[10] = 0x10;
    assert!(bench.write(0x1000, &message));
    assert_eq!(bench.send(FPRD, STATION, 0, &[0]).interrupt, 0x0020, "there is mail");
}

#[test]
fn wrong_addresses_are_told() {
    let mut bench = two();
    bench.send(FPRD, 0x1005, 0, &[0]);
    bench.send(APRD, 7_u16.wrapping_neg(), 0, &[0]);
    bench.logical(LRD, 0x0100_0000, &[0; 4]);
    bench.logical(LWR, 0x0100_0000, &[0; 4]);
    let told = bench.told();
    assert_eq!(
        told,
        [
            "a datagram went to station 0x1005, which there is not",
            "a datagram went to position 7, which there is not",
            "no FMMU maps any of the process data from 0x01000000 to 0x01000004",
        ]
    );
}
