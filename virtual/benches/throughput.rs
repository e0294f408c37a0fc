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

const CYCLES: u32 = 20_000;
const PERIOD: Duration = Duration::from_millis(1);
const LRW: u8 = 12;
const FRMW: u8 = 14;
const APWR: u8 = 2;

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
    let cycle = frame(&[(LRW, [0; 4], vec![0; outputs + inputs]), (FRMW, [1, 0x10, 0x10, 0x09], vec![0; 8])]);
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

/// Tells the lengths of process data.
fn bring_to_operational(wire: &mut Wire<Drive>) -> (usize, usize) {
    let (areas, lengths) = {
        let subdevice = wire.subdevices_mut().first_mut().expect("a subdevice");
        devc_virtual::Firmware::expected(&mut subdevice.firmware)
    };
    let mut write = |register: u16, data: &[u8]| {
        let [low, high] = register.to_le_bytes();
        let mut frame = frame(&[(APWR, [0, 0, low, high], data.to_vec())]);
        wire.pass(&mut frame);
        wire.advance(PERIOD);
    };
    let (outputs, inputs) = (lengths.outputs as u16, lengths.inputs as u16);
    let mail =
        |area: Option<devc_runtime::esm::Area>| area.map_or((0, 0), |area| (area.address, area.length.1));
    let address = |area: Option<devc_runtime::esm::Area>| area.map_or(0, |area| area.address);
    let managers = [
        (mail(areas.mailbox_out), 0x26),
        (mail(areas.mailbox_in), 0x22),
        ((address(areas.outputs), outputs), 0x64),
        ((address(areas.inputs), inputs), 0x20),
    ];
    write(0x0010, &[0x01, 0x10]);
    for (number, ((address, length), control)) in (0_u16..).zip(managers) {
        let ([a, b], [c, d]) = (address.to_le_bytes(), length.to_le_bytes());
        write(0x0800 + 8 * number, &[a, b, c, d, control, 0, 1, 0]);
    }
    let fmmus = [(0, outputs, address(areas.outputs), 2), (outputs, inputs, address(areas.inputs), 1)];
    for (number, (logical, length, address, kind)) in (0_u16..).zip(fmmus) {
        let [a, b] = logical.to_le_bytes();
        let ([c, d], [e, f]) = (length.to_le_bytes(), address.to_le_bytes());
        write(0x0600 + 16 * number, &[a, b, 0, 0, c, d, 0, 7, e, f, 0, kind, 1, 0, 0, 0]);
    }
    write(0x0120, &[2, 0]);
    write(0x0120, &[4, 0]);
    write(address(areas.outputs), &vec![0; lengths.outputs]);
    write(0x0120, &[8, 0]);
    (lengths.outputs, lengths.inputs)
}

/// An Ethernet frame with these datagrams: command, address, data.
fn frame(datagrams: &[(u8, [u8; 4], Vec<u8>)]) -> Vec<u8> {
    let mut body = Vec::new();
    for (number, (command, address, data)) in datagrams.iter().enumerate() {
        let more = if number + 1 < datagrams.len() { 0x8000 } else { 0 };
        body.extend([*command, 0]);
        body.extend(address);
        body.extend((data.len() as u16 | more).to_le_bytes());
        body.extend([0, 0]);
        body.extend(data);
        body.extend([0, 0]);
    }
    let mut frame = [[0xFF; 6], [0x10; 6]].concat();
    frame.extend([0x88, 0xA4]);
    frame.extend((body.len() as u16 | 0x1000).to_le_bytes());
    frame.extend(body);
    frame
}
