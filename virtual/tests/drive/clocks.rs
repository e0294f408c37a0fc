//! What devices make of the distributed clocks (ETG.1000.6, AL status codes 0x002D, 0x0030 and 0x0036).

use std::time::Duration;

use devc_runtime::esm::AlStatusCode;
use devc_virtual::{Clocks, Firmware};

use crate::bench::{Bench, OP, PRE_OP, SAFE_OP, device, devices};

const CYCLE: Option<Duration> = Some(Duration::from_millis(1));

/// What a master has set, and up to which state a device goes with that.
fn led(id: &str, clocks: Clocks) -> (Result<(), AlStatusCode>, Vec<String>) {
    let mut bench = Bench::new(device(id), None);
    bench.drive.clocked(clocks);
    let mut steps = || {
        bench.request(PRE_OP)?;
        bench.request(SAFE_OP)?;
        bench.cycle();
        bench.request(OP)
    };
    let led = steps();
    (led, bench.drive.take_events().iter().map(ToString::to_string).collect())
}

#[test]
fn signals_are_those_of_the_description() {
    let both = Clocks { sync0: CYCLE, sync1: CYCLE, are_missed: false };
    for (id, clocks, expected) in [
        ("c887", Clocks { sync1: None, ..both }, Ok(())),
        ("c887", both, Err(AlStatusCode(0x0030))),
        ("s700", Clocks { sync0: None, ..both }, Err(AlStatusCode(0x0030))),
        ("own", both, Ok(())),
        ("own", Clocks { sync1: None, ..both }, Err(AlStatusCode(0x0030))),
        ("double", Clocks { sync0: Some(Duration::ZERO), sync1: None, ..both }, Err(AlStatusCode(0x0036))),
        ("double", Clocks { sync1: None, are_missed: true, ..both }, Err(AlStatusCode(0x002D))),
    ] {
        assert_eq!(led(id, clocks).0, expected, "{id}: {clocks:?}");
    }
}

#[test]
fn every_device_runs_with_sync0_and_without_clocks() {
    for device in devices() {
        for sync0 in [CYCLE, None] {
            assert_eq!(led(&device.id, Clocks { sync0, ..Clocks::default() }).0, Ok(()), "{}", device.name);
        }
    }
}

/// C-887, p. 4: SYNC0 is the only mode, and a cycle has 1 ms at least. S700 and Pilz have a mode without clocks.
#[test]
fn a_master_is_told_what_does_not_fit() {
    let short = Clocks { sync0: Some(Duration::from_micros(500)), ..Clocks::default() };
    let right = Clocks { sync0: CYCLE, ..Clocks::default() };
    let (without, too_short) = (
        "runs without SYNC0, while distributed clocks are the only way in which it is said to keep time",
        "SYNC0 comes every 500µs, while its shortest cycle is 1ms",
    );
    for (id, clocks, told) in [
        ("c887", right, &[][..]),
        ("c887", short, &[too_short]),
        ("c887", Clocks::default(), &[without]),
        ("s700", Clocks::default(), &[]),
        ("double", short, &[]),
    ] {
        assert_eq!(led(id, clocks).1, told, "{id}: {clocks:?}");
    }
}
