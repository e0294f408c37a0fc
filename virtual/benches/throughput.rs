//! What a frame of process data costs: `cargo bench -p devc-virtual`.
//!
//! Each device is brought to Operational, and gets the frame of a cycle again and again: process data in one LRW, and the time
//! of the first clock for all. `wire` is the time until the frame is on its way back, `work` what the firmware does after it for
//! a cycle of 1 ms, `mirror` a device that only sends frames back.
#![allow(clippy::expect_used, clippy::print_stdout)] // a measurement may

use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use devc::source::Disk;
use devc_virtual::drive::Drive;
use devc_virtual::{Subdevice, Wire};

#[path = "shared/cycle.rs"]
mod cycle;

use cycle::{PERIOD, bring_to_operational};

const CYCLES: u32 = 20_000;

fn main() {
    println!("{:<14}{:>10}{:>10}{:>10}{:>14}", "", "wire", "work", "mirror", "frames/s");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices");
    for name in ["c887", "s700", "pmc-sc6"] {
        let family = devc::compile(&Disk, &folder.join(name)).family.expect("a description without errors");
        for device in &family.members {
            measure(&device.id, Subdevice::of(device));
        }
    }
}

fn measure(name: &str, subdevice: Subdevice<Drive>) {
    let mut wire = Wire::new(vec![subdevice]);
    let (outputs, inputs) = bring_to_operational(&mut wire);
    let cycle = cycle::frame_of_a_cycle(outputs + inputs);
    let pass = |wire: &mut Wire<Drive>| {
        let mut frame = cycle.clone();
        wire.elapse(PERIOD);
        wire.pass(&mut frame);
        assert_eq!(frame.get(26 + outputs + inputs), Some(&3), "{name} does not answer");
    };
    let both = taken(|| {
        pass(&mut wire);
        wire.work();
    });
    let passed = taken(|| pass(&mut wire));
    let mirrored = taken(|| drop(black_box(black_box(&cycle).clone())));
    let each = |time: Duration| format!("{:.2} µs", (time / CYCLES).as_secs_f64() * 1e6);
    let rate = f64::from(CYCLES) / both.as_secs_f64();
    let worked = both.saturating_sub(passed);
    println!("{name:<14}{:>10}{:>10}{:>10}{rate:>14.0}", each(passed), each(worked), each(mirrored));
}

/// The time that so many cycles take.
fn taken(mut cycle: impl FnMut()) -> Duration {
    let begin = now();
    (0..CYCLES).for_each(|_| cycle());
    now().saturating_sub(begin)
}

/// The time for which this process was on a core, so that others do not count; where that is not told, the time of day.
fn now() -> Duration {
    let told = fs::read_to_string("/proc/self/schedstat").ok();
    let told = told.and_then(|told| told.split(' ').next()?.parse().ok());
    told.map_or_else(
        || SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default(),
        Duration::from_nanos,
    )
}
