//! FMMUs, against ETG.1000.4, FMMU: to the bit.

use crate::devices::{all, c887};
use crate::master::*;

const USER: u16 = 0x0F80;

/// Registers of an FMMU: logical address, length, first and last bit, physical address and bit, type.
fn fmmu(bench: &mut Bench, number: u16, logical: (u32, u16, u8, u8), physical: (u16, u8), kind: u8) {
    let (address, length, first, last) = logical;
    let mut registers = Vec::from(address.to_le_bytes());
    registers.extend(length.to_le_bytes());
    registers.extend([first, last]);
    registers.extend(physical.0.to_le_bytes());
    registers.extend([physical.1, kind, 1, 0, 0, 0]);
    assert!(bench.write(0x0600 + 16 * number, &registers));
}

#[test]
fn bytes_are_mapped_as_far_as_they_overlap() {
    let mut bench = Bench::of(c887());
    bench.write(USER, &[1, 2, 3, 4]);
    fmmu(&mut bench, 0, (0x1_0000, 4, 0, 7), (USER, 0), 1);
    let cases: [(u32, &[u8], &[u8]); 6] = [
        (0x1_0000, &[9; 4], &[1, 2, 3, 4]),
        (0x1_0001, &[9; 2], &[2, 3]),
        (0x0_FFFF, &[9; 6], &[9, 1, 2, 3, 4, 9]),
        (0x1_0003, &[9; 3], &[4, 9, 9]),
        (0x1_0004, &[9; 2], &[9, 9]),
        (0x0_FFFE, &[9; 2], &[9, 9]),
    ];
    for (address, data, back) in cases {
        let answer = bench.logical(LRD, address, data);
        assert_eq!(answer.data, back, "0x{address:X}");
        assert_eq!(answer.counter, u16::from(data != back));
        assert_eq!(bench.logical(LWR, address, data).counter, 0, "it is for reading");
    }
}

#[test]
fn the_last_logical_address_is_one() {
    let mut bench = Bench::of(c887());
    fmmu(&mut bench, 0, (0xFFFF_FFFE, 4, 0, 7), (USER, 0), 3);
    assert_eq!(bench.logical(LRW, 0xFFFF_FFFE, &[7, 8]).counter, 3);
    assert_eq!(bench.read(USER), Some([7, 8, 0, 0]));
}

/// Bits 3 to 12 of logical memory onto bits 6 to 15 in memory, and back.
#[test]
fn bits_are_mapped_alone() {
    let mut bench = Bench::of(c887());
    bench.write(USER, &[0xFF, 0xFF, 0xFF]);
    fmmu(&mut bench, 0, (0x2000, 2, 3, 4), (USER, 6), 2);
    assert_eq!(bench.logical(LWR, 0x2000, &[0b1010_1000, 0b1110_0101]).counter, 1);
    // bits from 3 on: 1 0 1 0 1, then 1 0 1 0 0
    let expected = 0b1111_1111_u32 << 16 | 0b00_1011_0101 << 6 | 0b11_1111;
    assert_eq!(bench.read(USER), Some(*expected.to_le_bytes().first_chunk::<3>().unwrap()));
    fmmu(&mut bench, 0, (0x2000, 2, 3, 4), (USER, 6), 1);
    let answer = bench.logical(LRD, 0x2000, &[0, 0]);
    assert_eq!((answer.data, answer.counter), (vec![0b1010_1000, 0b0000_0101], 1));
    let answer = bench.logical(LRD, 0x2000, &[0xFF, 0xFF]);
    assert_eq!(answer.data, [0b1010_1111, 0b1110_0101], "the other bits are others'");
}

/// The status of a mailbox as one bit of process data, as masters map it.
#[test]
fn a_bit_of_a_register_is_mapped() {
    let mut bench = Bench::of(c887());
    crate::states::to_pre_operational(&mut bench);
    fmmu(&mut bench, 2, (0x3000, 1, 0, 0), (0x080D, 3), 1);
    assert_eq!(bench.logical(LRD, 0x3000, &[0]).data, [0]);
    let mut message = [0; 128];
    message[..11].copy_from_slice(&[10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x40, 0x00, 0x10]);
    bench.write(0x1000, &message);
    assert_eq!(bench.logical(LRD, 0x3000, &[0]).data, [1]);
}

/// LRW counts 1 for what was read and 2 for what was written, of each device; what is written comes from the frame as it came.
#[test]
fn reading_and_writing_are_counted_apart() {
    let subdevices = all().into_iter().take(3).map(crate::devices::Device::subdevice).collect();
    let mut bench = Bench::new(subdevices);
    for position in 0..3_u16 {
        let address = position.wrapping_neg();
        bench.send(APWR, address, 0x0010, &(STATION + position).to_le_bytes());
        bench.send(APWR, address, USER, &[0x50 + position as u8, 0]);
        for (number, target, kind) in [(0_u16, USER, 1_u8), (1, USER + 1, 2)] {
            let [low, high] = target.to_le_bytes();
            let registers = [position as u8, 0, 0, 0, 1, 0, 0, 7, low, high, 0, kind, 1, 0, 0, 0];
            bench.send(APWR, address, 0x0600 + 16 * number, &registers);
        }
    }
    let answer = bench.logical(LRW, 0, &[1, 2, 3]);
    assert_eq!((answer.counter, answer.data), (9, vec![0x50, 0x51, 0x52]));
    for position in 0..3_u16 {
        let written = bench.send(FPRD, STATION + position, USER + 1, &[0]).data;
        assert_eq!(written, [position as u8 + 1]);
    }
    assert_eq!(bench.logical(LRD, 0, &[0; 3]).counter, 3);
    assert_eq!(bench.logical(LWR, 0, &[0; 3]).counter, 3);
}

#[test]
fn what_is_not_active_maps_nothing() {
    let mut bench = Bench::of(c887());
    fmmu(&mut bench, 0, (0, 1, 0, 7), (USER, 0), 3);
    assert!(bench.write(0x060C, &[0]));
    assert_eq!(bench.logical(LRW, 0, &[1]).counter, 0);
}
