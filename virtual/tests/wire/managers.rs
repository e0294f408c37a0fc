//! Sync managers, against ETG.1000.4, sync manager: mailboxes and three buffers.

use devc_runtime::coe::{Answered, Download, Upload};
use devc_runtime::object::Address;

use crate::devices::c887;
use crate::master::*;
use crate::states::{manager, off, to_pre_operational, to_safe_operational};

/// Reads 0x1000 with a counter: the device type.
fn question(counter: u8) -> [u8; 128] {
    let mut message = [0; 128];
    let length = Upload::new(Address::new(0x1000, 0), &mut [0; 4]).request(counter, &mut message);
    assert_eq!(length, Ok(16));
    message
}

/// Bit 3 of the status: whether the mailbox is full.
fn is_full(bench: &mut Bench, manager: u16) -> bool {
    bench.read::<1>(0x0805 + 8 * manager).unwrap()[0] & 0x08 != 0
}

#[test]
fn a_message_is_answered() {
    let mut bench = Bench::of(c887());
    to_pre_operational(&mut bench);
    assert!(!is_full(&mut bench, 1));
    assert_eq!(bench.read::<128>(0x1080), None, "there is nothing to be read");
    assert!(bench.write(0x1000, &question(1)));
    assert!(is_full(&mut bench, 1) && !is_full(&mut bench, 0));
    let answer = bench.read::<128>(0x1080).unwrap();
    let mut value = [0; 4];
    let mut upload = Upload::new(Address::new(0x1000, 0), &mut value);
    upload.request(1, &mut [0; 16]).unwrap();
    assert_eq!(upload.take(&answer), Ok(Answered::Done));
    // a servo drive after CiA 402
    assert_eq!(upload.value()[..2], 402_u16.to_le_bytes());
    assert!(!is_full(&mut bench, 1));
    assert_eq!(bench.read::<128>(0x1080), None, "it is read once");
}

/// A mailbox is written from its first byte to its last, and not again before the device has taken it.
#[test]
fn a_mailbox_takes_one_message_at_a_time() {
    let mut bench = Bench::of(c887());
    to_pre_operational(&mut bench);
    let write = |from: u16, to: u16| {
        let message = question(1);
        Datagram::new(FPWR, STATION, 0x1000 + from, &message[from.into()..to.into()])
    };
    let status = Datagram::new(FPRD, STATION, 0x0805, &[0]);
    let pieces = [
        write(64, 128),
        write(0, 16),
        status.clone(),
        write(16, 127),
        write(127, 128),
        status,
        write(0, 128),
    ];
    let answers = bench.all(&pieces);
    let counters: Vec<u16> = answers.iter().map(|answer| answer.counter).collect();
    assert_eq!(counters, [0, 1, 1, 1, 1, 1, 0], "not without the first byte, and not twice");
    assert_eq!([&answers[2], &answers[5]].map(|answer| answer.data[0] & 0x08), [0, 0x08]);
    // the answer waits, and the next message waits for the answer to be read
    assert!(bench.write(0x1000, &question(2)));
    assert!(is_full(&mut bench, 0) && is_full(&mut bench, 1));
    assert!(bench.read::<128>(0x1080).is_some());
    assert!(bench.read::<128>(0x1080).is_some());
    assert!(!is_full(&mut bench, 0) && !is_full(&mut bench, 1));
}

/// ETG.1000.4, repeat request: the master toggles bit 1 of 0x0806, the device answers in bit 1 of 0x0807.
#[test]
fn a_lost_answer_is_repeated() {
    let mut bench = Bench::of(c887());
    to_pre_operational(&mut bench);
    bench.write(0x1000, &question(1));
    let answer = bench.read::<128>(0x1080).unwrap();
    for toggle in [0x02, 0x00] {
        assert!(bench.write(0x080E, &[0x01 | toggle]));
        assert_eq!(bench.read(0x080F), Some([toggle]));
        assert_eq!(bench.read::<128>(0x1080), Some(answer));
        assert_eq!(bench.read::<128>(0x1080), None);
    }
}

#[test]
fn refusals_of_the_mailbox_are_told() {
    let mut bench = Bench::of(c887());
    to_pre_operational(&mut bench);
    let mut message = [0; 128];
    Download::new(Address::new(0x6064, 0), &[0; 4]).request(1, &mut message).unwrap();
    bench.write(0x1000, &message);
    bench.read::<128>(0x1080).unwrap();
    let mut other = [0; 128];
    other[..8].copy_from_slice(&[4, 0, 0, 0, 0, 0x24, 0, 0]);
    bench.write(0x1000, &other);
    let answer = bench.read::<128>(0x1080).unwrap();
    assert_eq!((answer[5] & 0x0F, answer[8]), (0, 2), "an unsupported protocol");
    let told = bench.told().join("\n");
    assert!(
        told.contains("aborts the SDO transfer of 0x6064:00: 0x06010002: the entry can only be read"),
        "{told}"
    );
    assert!(told.contains("cannot read a mailbox message: error 2"), "{told}");
}

/// What is written in pieces is seen as a whole, and what is read in pieces stays what it was at the first byte.
#[test]
fn process_data_is_consistent() {
    let mut bench = Bench::of(c887());
    to_safe_operational(&mut bench);
    let piece = |from: u16, to: u16| {
        let length = usize::from(to - from);
        Datagram::new(FPRD, STATION, 0x1400 + from, &vec![0; length])
    };
    // not without the first byte
    let answers = bench.all(&[piece(6, 66), piece(0, 6), piece(6, 66), piece(6, 66)]);
    let counters: Vec<u16> = answers.iter().map(|answer| answer.counter).collect();
    assert_eq!(counters, [0, 1, 1, 0]);
    // while one is being read, the device goes on
    assert_eq!(bench.all(&[piece(0, 6)])[0].counter, 1);
    for _ in 0..5 {
        bench.wait(std::time::Duration::from_millis(1));
    }
    assert_eq!(bench.all(&[piece(6, 66)])[0].counter, 1);
    // the direction is fixed
    assert!(!bench.write(0x1400, &[0; 66]));
    assert_eq!(bench.read::<42>(0x1100), None);
    // the second and the third buffer are not to be touched
    assert!(!bench.write(0x1100 + 42, &[0; 42]));
    assert!(bench.write(0x1100, &[0; 42]));
}

/// The number of the buffer that was written last, in bits 4 and 5 of the status: 3 before the first, then in turn.
#[test]
fn buffers_take_turns() {
    let mut bench = Bench::of(c887());
    to_safe_operational(&mut bench);
    let buffer = |bench: &mut Bench| bench.read::<1>(0x0815).unwrap()[0] >> 4 & 3;
    assert_eq!(buffer(&mut bench), 3);
    let mut seen = std::collections::BTreeSet::new();
    for _ in 0..6 {
        assert!(bench.write(0x1100, &[0; 42]));
        seen.insert(buffer(&mut bench));
    }
    assert_eq!(seen.into_iter().collect::<Vec<_>>(), [0, 1, 2]);
}

#[test]
fn settings_are_changed_while_it_is_off() {
    let mut bench = Bench::of(c887());
    manager(&mut bench, 0, (0x1000, 128), 0x26);
    assert!(!bench.write(0x0802, &[64, 0]));
    assert_eq!(bench.read(0x0802), Some([128, 0]));
    off(&mut bench, 0);
    assert!(bench.write(0x0802, &[64, 0]));
    assert_eq!(bench.read(0x0802), Some([64, 0]));
}

/// Three buffers of 42 bytes from 0x1100 on end at 0x117E.
#[test]
fn areas_that_share_memory_are_told() {
    for (address, is_told) in [(0x117D, true), (0x117E, false)] {
        let mut bench = Bench::of(c887());
        manager(&mut bench, 2, (0x1100, 42), 0x64);
        manager(&mut bench, 3, (address, 66), 0x20);
        let told = bench.told().join("\n");
        assert_eq!(told.contains("sync managers 2 and 3 share memory"), is_told, "{told}");
    }
}
