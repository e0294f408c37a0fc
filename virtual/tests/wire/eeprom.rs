//! The EEPROM through its registers, against ETG.1000.4, subdevice information interface.

use std::time::Duration;

use devc_virtual::Subdevice;

use crate::devices::c887;
use crate::master::*;

const BUSY: u16 = 0x8000;
const REFUSED: u16 = 0x2000;

/// Writes a command with its address, and waits until it is done; tells the status.
fn command(bench: &mut Bench, control: u16, address: u32) -> u16 {
    let mut registers = Vec::from(control.to_le_bytes());
    registers.extend(address.to_le_bytes());
    assert!(bench.write(0x0502, &registers));
    for _ in 0..100 {
        let status = u16::from_le_bytes(bench.read(0x0502).unwrap());
        if status & BUSY == 0 {
            return status;
        }
    }
    panic!("it stays busy");
}

#[test]
fn it_is_read_eight_bytes_at_once() {
    let mut bench = Bench::of(c887());
    let status = command(&mut bench, 0x0100, 0x08);
    assert_eq!(status, 0x0040, "eight bytes, no error");
    assert_eq!(bench.read(0x0508), Some([0x6D, 0x07, 0, 0, 3, 0, 0, 0]), "PI, C-887: p. 21");
    // behind the image it is empty, and behind that it ends
    command(&mut bench, 0x0100, 0x3FE);
    assert_eq!(bench.read(0x0508), Some([0xFF; 8]));
    assert_ne!(command(&mut bench, 0x0100, 0x400) & REFUSED, 0);
    assert_eq!(command(&mut bench, 0x0000, 0) & REFUSED, 0, "the error is cleared");
}

/// ETG.1000.4: busy while it is read; a command that comes then is not taken.
#[test]
fn it_takes_its_time() {
    let mut bench = Bench::of(c887());
    let read = Datagram::new(FPWR, STATION, 0x0502, &[0, 1, 8, 0, 0, 0]);
    let other = Datagram::new(FPWR, STATION, 0x0502, &[0, 1, 10, 0, 0, 0]);
    let status = Datagram::new(FPRD, STATION, 0x0502, &[0; 2]);
    let answers = bench.all(&[read, status, other]);
    assert_eq!([answers[0].counter, answers[2].counter], [1, 0]);
    assert_eq!(answers[1].data[1] & 0x80, 0x80);
    bench.wait(Duration::from_millis(1));
    assert_eq!(bench.read(0x0508), Some([0x6D, 0x07, 0, 0, 3, 0, 0, 0]));
}

#[test]
fn it_is_written_if_that_is_enabled() {
    let mut bench = Bench::of(c887());
    let write = |bench: &mut Bench, control: u16| {
        let mut registers = Vec::from(control.to_le_bytes());
        registers.extend([4, 0, 0, 0, 0xCD, 0xAB]);
        assert!(bench.write(0x0502, &registers));
        bench.wait(Duration::from_millis(5));
        u16::from_le_bytes(bench.read(0x0502).unwrap())
    };
    assert_eq!(write(&mut bench, 0x0200), 0x4040, "it was not enabled");
    command(&mut bench, 0x0100, 4);
    assert_eq!(bench.read(0x0508), Some([0x23, 0x01]));
    assert_eq!(write(&mut bench, 0x0201), 0x0040);
    command(&mut bench, 0x0100, 4);
    assert_eq!(bench.read(0x0508), Some([0xCD, 0xAB]));
    // now the checksum is wrong: it is told at the next start, and the alias stays
    assert_eq!(command(&mut bench, 0x0400, 0) & 0x0800, 0x0800);
    assert_eq!(bench.read(0x0012), Some([0x23, 0x01]));
}

#[test]
fn a_command_that_there_is_not_is_refused() {
    let mut bench = Bench::of(c887());
    for number in [3, 5, 6, 7] {
        assert_ne!(command(&mut bench, number << 8, 0) & REFUSED, 0, "{number}");
    }
}

#[test]
fn while_the_firmware_has_it_a_master_does_not() {
    let mut bench = Bench::of(c887());
    assert!(bench.write(0x0500, &[1]));
    assert!(!bench.write(0x0502, &[0, 1, 8, 0, 0, 0]));
    assert!(bench.write(0x0500, &[0]));
    assert_eq!(command(&mut bench, 0x0100, 8) & REFUSED, 0);
}

#[test]
fn any_image_will_do() {
    for image in [vec![], vec![0], vec![0xFF; 13], vec![0; 128], vec![0xFF; 5001]] {
        let mut bench = Bench::new(vec![Subdevice::new(c887().firmware, image)]);
        bench.send(APWR, 0, 0x0010, &STATION.to_le_bytes());
        for word in [0, 7, 0x3E, 0x40, 2500, 2501, 0xFFFF_FFFF] {
            command(&mut bench, 0x0100, word);
        }
    }
}

/// Off and on again: registers are as after a reset, what was written into the EEPROM is still there.
#[test]
fn it_outlasts_a_power_cycle() {
    let mut bench = Bench::of(c887());
    let mut registers = Vec::from(0x0201_u16.to_le_bytes());
    registers.extend([0x50, 0, 0, 0, 0xCD, 0xAB]);
    assert!(bench.write(0x0502, &registers));
    bench.wait(Duration::from_millis(5));
    crate::states::to_pre_operational(&mut bench);
    bench.wire.subdevices_mut()[0].restart(c887().firmware);
    assert_eq!(bench.read::<2>(0x0130), None, "its station address is gone");
    bench.send(APWR, 0, 0x0010, &STATION.to_le_bytes());
    assert_eq!(bench.read(0x0130), Some([0x01, 0]));
    assert_eq!(bench.read(0x0806), Some([0]), "no sync manager is on");
    command(&mut bench, 0x0100, 0x50);
    assert_eq!(bench.read(0x0508), Some([0xCD, 0xAB]));
}
