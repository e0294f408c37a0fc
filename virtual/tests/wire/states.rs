//! The EtherCAT state machine over registers, with what is told of refusals.

use std::time::Duration;

use crate::devices::{c887, s700};
use crate::master::*;

/// Sets a sync manager and switches it on.
pub(crate) fn manager(bench: &mut Bench, number: u16, (address, length): (u16, u16), control: u8) {
    let [a, b] = address.to_le_bytes();
    let [c, d] = length.to_le_bytes();
    assert!(bench.write(0x0800 + 8 * number, &[a, b, c, d, control, 0, 1, 0]));
}

pub(crate) fn off(bench: &mut Bench, number: u16) {
    assert!(bench.write(0x0806 + 8 * number, &[0]));
}

pub(crate) fn request(bench: &mut Bench, control: u16) -> (u16, u16) {
    assert!(bench.write(0x0120, &control.to_le_bytes()));
    let [status, _, _, _, code_low, code_high] = bench.read(0x0130).unwrap();
    (status.into(), u16::from_le_bytes([code_low, code_high]))
}

/// The C-887 with its mailboxes on.
pub(crate) fn to_pre_operational(bench: &mut Bench) {
    manager(bench, 0, (0x1000, 128), 0x26);
    manager(bench, 1, (0x1080, 128), 0x22);
    assert_eq!(request(bench, 0x02), (0x02, 0));
}

/// And with process data: outputs at logical address 0x1000, inputs at 0x2000.
pub(crate) fn to_safe_operational(bench: &mut Bench) {
    to_pre_operational(bench);
    manager(bench, 2, (0x1100, 42), 0x64);
    manager(bench, 3, (0x1400, 66), 0x20);
    bench.write(0x0600, &[0, 0x10, 0, 0, 42, 0, 0, 7, 0x00, 0x11, 0, 2, 1, 0, 0, 0]);
    bench.write(0x0610, &[0, 0x20, 0, 0, 66, 0, 0, 7, 0x00, 0x14, 0, 1, 1, 0, 0, 0]);
    assert_eq!(request(bench, 0x04), (0x04, 0));
}

fn to_operational(bench: &mut Bench) {
    to_safe_operational(bench);
    assert_eq!(bench.logical(LWR, 0x1000, &[0; 42]).counter, 1);
    assert_eq!(request(bench, 0x08), (0x08, 0));
}

/// ETG.1000.6, AL status codes: 0x16 invalid mailbox, 0x1D invalid outputs, 0x1E invalid inputs, 0x11 invalid change, 0x12
/// unknown state, 0x13 no Bootstrap, 0x19 no valid outputs.
#[test]
fn what_is_set_wrongly_is_refused_with_the_code_of_the_standard() {
    let mut bench = Bench::of(c887());
    assert_eq!(request(&mut bench, 0x02), (0x11, 0x16), "the mailboxes are off");
    manager(&mut bench, 0, (0x1000, 64), 0x26);
    manager(&mut bench, 1, (0x1080, 128), 0x22);
    assert_eq!(request(&mut bench, 0x12), (0x11, 0x16), "the mailbox is too short");
    off(&mut bench, 0);
    to_acknowledged(&mut bench, 0x11);
    to_pre_operational(&mut bench);
    assert_eq!(request(&mut bench, 0x08), (0x12, 0x11));
    assert_eq!(request(&mut bench, 0x17), (0x12, 0x12));
    assert_eq!(request(&mut bench, 0x13), (0x12, 0x11), "not from here");
    to_acknowledged(&mut bench, 0x12);
    manager(&mut bench, 2, (0x1100, 40), 0x64);
    manager(&mut bench, 3, (0x1400, 66), 0x20);
    assert_eq!(request(&mut bench, 0x04), (0x12, 0x1D));
    off(&mut bench, 2);
    off(&mut bench, 3);
    manager(&mut bench, 2, (0x1100, 42), 0x64);
    manager(&mut bench, 3, (0x1400, 64), 0x20);
    assert_eq!(request(&mut bench, 0x14), (0x12, 0x1E));
    let told = bench.told().join("\n");
    for words in [
        "does not go to Pre-Operational: 0x0016: a sync manager of the mailbox is wrong; sync manager 0 is off; sync manager 1 is off",
        "sync manager 0 has 64 bytes instead of 128",
        "does not go to Operational: 0x0011",
        "sync manager 2 has 40 bytes instead of 42",
        "sync manager 3 has 64 bytes instead of 66",
    ] {
        assert!(told.contains(words), "{words} in\n{told}");
    }
}

fn to_acknowledged(bench: &mut Bench, status: u16) {
    let state = status & 0x0F;
    assert_eq!(request(bench, state | 0x10), (state, 0));
}

#[test]
fn operational_begins_with_outputs() {
    let mut bench = Bench::of(c887());
    to_safe_operational(&mut bench);
    assert_eq!(request(&mut bench, 0x08), (0x14, 0x19));
    to_acknowledged(&mut bench, 0x14);
    assert_eq!(bench.logical(LWR, 0x1000, &[0; 42]).counter, 1);
    assert_eq!(request(&mut bench, 0x08), (0x08, 0));
}

/// The registers as they are after a reset: 100 ms, from (2498 + 2) · 40 ns · 1000.
#[test]
fn the_watchdog_takes_it_out_of_operational() {
    let mut bench = Bench::of(c887());
    to_operational(&mut bench);
    for _ in 0..5 {
        bench.wait(Duration::from_millis(99));
        assert_eq!(bench.logical(LWR, 0x1000, &[0; 42]).counter, 1);
    }
    assert_eq!(bench.read::<1>(0x0440), Some([1]));
    assert_eq!(bench.read::<2>(0x0130), Some([0x08, 0]));
    // inputs alone are no sign of life
    for _ in 0..5 {
        bench.wait(Duration::from_millis(20));
        assert_eq!(bench.logical(LRD, 0x2000, &[0; 66]).counter, 1);
    }
    assert_eq!(bench.read::<1>(0x0440), Some([0]));
    assert_eq!(bench.read::<6>(0x0130), Some([0x14, 0, 0, 0, 0x1B, 0]));
    assert_eq!(bench.read::<1>(0x0442), Some([1]), "it counts");
    let told = bench.told();
    assert!(told.iter().any(|event| event.contains("no outputs came for 100ms")), "{told:?}");
    assert!(told.iter().any(|event| event.contains("fell to Safe-Operational: 0x001B")), "{told:?}");
}

#[test]
fn the_time_of_the_watchdog_is_the_masters() {
    for (time, is_off) in [(20_u16, false), (0, true)] {
        let mut bench = Bench::of(c887());
        assert!(bench.write(0x0420, &time.to_le_bytes()));
        to_operational(&mut bench);
        bench.wait(Duration::from_millis(3));
        let status = if is_off { 0x08 } else { 0x14 };
        assert_eq!(bench.read::<1>(0x0130), Some([status]), "{time}");
        assert_eq!(bench.read::<1>(0x0440), Some([is_off.into()]));
    }
    // bit 6 of the control byte off: no watchdog
    let mut bench = Bench::of(s700());
    manager(&mut bench, 0, (0x1800, 512), 0x26);
    manager(&mut bench, 1, (0x1C00, 512), 0x22);
    assert_eq!(request(&mut bench, 0x02), (0x02, 0));
    manager(&mut bench, 2, (0x1100, 6), 0x24);
    manager(&mut bench, 3, (0x1140, 6), 0x20);
    assert_eq!(request(&mut bench, 0x04), (0x04, 0));
    assert!(bench.write(0x1100, &[0; 6]));
    assert_eq!(request(&mut bench, 0x08), (0x08, 0));
    bench.wait(Duration::from_secs(10));
    assert_eq!(bench.read::<1>(0x0130), Some([0x08]));
}
