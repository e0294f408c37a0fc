//! How long a frame is on its way over a real interface: `cargo bench -p devc-virtual --features raw-socket --bench latency`.
//!
//! A virtual cable is made, which takes root: at one end a master sends the frame of a cycle and waits for it, at the other end
//! stands a device. Of two frames one is for a mirror, which only marks a frame as returned and sends it back over the same
//! socket, so that both are measured at the same time on the same machine. The difference is what the device adds.
#![allow(clippy::expect_used, clippy::print_stdout, clippy::indexing_slicing)] // a measurement may

use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use devc::source::Disk;
use devc_virtual::drive::Drive;
use devc_virtual::{Interface, Subdevice, Wire};

#[path = "shared/cycle.rs"]
mod cycle;

/// The ends of the cable.
const MASTER: &str = "devc-bench-m";
const DEVICE: &str = "devc-bench-d";

const FRAMES: usize = 3_000;
/// How long a master waits before it takes a frame for lost.
const LOST: Duration = Duration::from_millis(50);
/// Where a frame has the number of its first datagram, and the bit that marks it as returned.
const NUMBER: usize = 17;
const SOURCE: usize = 6;

fn main() {
    let links = [
        &["link", "add", MASTER, "type", "veth", "peer", "name", DEVICE][..],
        &["link", "set", MASTER, "up"],
        &["link", "set", DEVICE, "up"],
    ];
    if !links.into_iter().all(ip) {
        println!("skipped: a virtual cable takes root and `ip`");
        return;
    }
    println!(
        "{:<10}{:>9}{:>9}{:>11}{:>9}{:>11}{:>9}",
        "", "mirror", "90 %", "device", "90 %", "added", "lost"
    );
    for (folder, id) in [("c887", "c887"), ("pmc-sc6", "double"), ("s700", "s700")] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(folder);
        let family = devc::compile(&Disk, &folder).family.expect("a description without errors");
        let device = family.members.iter().find(|device| device.id == id).expect("it is a member");
        measure(id, Subdevice::of(device));
    }
    ip(&["link", "delete", MASTER]);
}

fn ip(arguments: &[&str]) -> bool {
    Command::new("ip").args(arguments).status().is_ok_and(|status| status.success())
}

fn measure(name: &str, subdevice: Subdevice<Drive>) {
    let mut wire = Wire::new(vec![subdevice]);
    let (outputs, inputs) = cycle::bring_to_operational(&mut wire);
    let frame = cycle::frame_of_a_cycle(outputs + inputs);
    let is_over = AtomicBool::new(false);
    let (times, lost) = thread::scope(|scope| {
        scope.spawn(|| serve(wire, &is_over));
        let times = send(&frame, 26 + outputs + inputs);
        is_over.store(true, Ordering::Relaxed);
        times
    });
    let [mirror, device] = times.map(|mut times| {
        times.sort();
        [times[times.len() / 2], times[times.len() * 9 / 10]].map(|time| time.as_secs_f64() * 1e6)
    });
    let added = device[0] - mirror[0];
    println!(
        "{name:<10}{:>6.1} µs{:>6.1} µs{:>8.1} µs{:>6.1} µs{added:>8.1} µs{lost:>9}",
        mirror[0], mirror[1], device[0], device[1]
    );
}

/// The device and the mirror: frames with an odd number are for the device.
fn serve(mut wire: Wire<Drive>, is_over: &AtomicBool) {
    let mut interface = Interface::open(DEVICE).expect("the cable is there");
    let mut known = Instant::now();
    while !is_over.load(Ordering::Relaxed) {
        interface.wait(Duration::from_micros(500)).expect("the cable is there");
        while let Some(mut frame) = interface.receive().expect("the cable is there") {
            if frame.get(12..14) != Some(&[0x88, 0xA4]) {
                continue;
            }
            if frame[NUMBER] % 2 == 0 {
                frame[SOURCE] |= 0x02;
                interface.send(&frame).expect("the cable is there");
                continue;
            }
            let now = Instant::now();
            wire.elapse(now - known);
            known = now;
            wire.pass(&mut frame);
            interface.send(&frame).expect("the cable is there");
            wire.work();
        }
    }
}

/// Sends frames in turn to the mirror and to the device: how long each was on its way, and how many were lost.
fn send(frame: &[u8], counter: usize) -> ([Vec<Duration>; 2], usize) {
    let mut interface = Interface::open(MASTER).expect("the cable is there");
    let (mut times, mut lost) = ([Vec::new(), Vec::new()], 0);
    for number in 0..2 * FRAMES {
        let mut frame = frame.to_vec();
        frame[NUMBER] = number as u8;
        let begin = Instant::now();
        interface.send(&frame).expect("the cable is there");
        let back = loop {
            if begin.elapsed() > LOST {
                break None;
            }
            let came = interface.receive().expect("the cable is there");
            let is_it = |back: &Vec<u8>| back.get(NUMBER) == frame.get(NUMBER) && back[SOURCE] & 0x02 != 0;
            if let Some(back) = came.filter(is_it) {
                break Some((begin.elapsed(), back));
            }
        };
        match back {
            Some((time, back)) => {
                let expected = if number % 2 == 0 { 0 } else { 3 };
                assert_eq!(back[counter], expected, "the working counter");
                times[number % 2].push(time);
            }
            None => lost += 1,
        }
        // by the next frame the firmware has done its work
        thread::sleep(cycle::PERIOD);
    }
    (times, lost)
}
