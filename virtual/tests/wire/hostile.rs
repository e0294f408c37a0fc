//! Frames that no master would send: nothing panics, no length changes, and the device goes on.

use std::time::Duration;

use crate::devices::{Device, all, c887};
use crate::master::*;
use crate::states::to_safe_operational;

/// Numbers that are the same each time (xorshift64*).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() >> 33) as usize % end
    }

    fn bytes(&mut self, length: usize) -> Vec<u8> {
        (0..length).map(|_| self.next() as u8).collect()
    }
}

fn pass(bench: &mut Bench, frame: &mut [u8]) {
    bench.wire.pass(frame);
    bench.wait(Duration::from_micros(50));
    bench.wire.take_events();
}

#[test]
fn random_bytes_pass() {
    let mut random = Random(0x0D15_EA5E);
    let mut bench = Bench::new(all().into_iter().map(Device::subdevice).collect());
    for _ in 0..2_000 {
        let length = random.below(1600);
        let mut frame = random.bytes(length);
        // most have the right type, so that they are read at all
        if let Some(head) = frame.get_mut(12..16).filter(|_| random.below(8) != 0) {
            head[..2].copy_from_slice(&[0x88, 0xA4]);
            head[3] = head[3] & 0x0F | 0x10;
        }
        pass(&mut bench, &mut frame);
    }
    assert_eq!(bench.send(BRD, 0, 0, &[0]).counter, 9);
}

/// Datagrams that are in order, to any place with any data: registers, mailboxes, and what maps them.
#[test]
fn any_datagram_is_answered() {
    let mut random = Random(0xC0FF_EE00);
    let mut bench = Bench::of(c887());
    for round in 0..4_000 {
        if round % 500 == 0 {
            bench = Bench::of(c887());
            to_safe_operational(&mut bench);
        }
        let datagrams: Vec<_> = (0..=random.below(6))
            .map(|_| {
                let place = match random.below(4) {
                    0 => random.next() as u16,
                    1 => 0x0600 + random.below(0x0300) as u16,
                    2 => random.below(0x0A00) as u16,
                    _ => 0x0FF0 + random.below(0x0500) as u16,
                };
                let length = random.below(200);
                let station = if random.below(4) == 0 { 0 } else { STATION };
                Datagram::new(random.below(16) as u8, station, place, &random.bytes(length))
            })
            .collect();
        let mut frame = frame(&datagrams);
        pass(&mut bench, &mut frame);
        let back = parse(&frame);
        assert_eq!(back.len(), datagrams.len());
        for (went, came) in datagrams.iter().zip(&back) {
            assert_eq!((went.command, went.data.len()), (came.command, came.data.len()));
        }
    }
    let count = bench.send(BRD, 0, 0, &[0]).counter;
    assert_eq!(count, 1);
}

/// Frames of a start-up, each with some bytes changed or cut off.
#[test]
fn frames_that_went_wrong_pass() {
    let mut random = Random(0xBAD_F00D);
    let mut message = [0; 128];
    message[..12].copy_from_slice(&[10, 0, 0, 0, 0, 0x13, 0, 0x80, 1, 0, 0, 0]);
    let frames = [
        frame(&[
            Datagram::new(FPWR, STATION, 0x0120, &[4, 0]),
            Datagram::new(FPRD, STATION, 0x0130, &[0; 6]),
        ]),
        frame(&[
            Datagram::new(FPWR, STATION, 0x1000, &message),
            Datagram::new(FPRD, STATION, 0x1080, &[0; 128]),
        ]),
        frame(&[Datagram::logical(LRW, 0x1000, &[0; 300]), Datagram::new(FRMW, STATION, 0x0910, &[0; 8])]),
        frame(&[Datagram::new(FPWR, STATION, 0x0810, &[0, 0x11, 42, 0, 0x64, 0, 1, 0])]),
        frame(&[Datagram::new(FPWR, STATION, 0x0600, &[0xFF; 16]), Datagram::logical(LRW, 0, &[0; 64])]),
    ];
    let mut bench = Bench::of(c887());
    for round in 0..5_000 {
        if round % 500 == 0 {
            bench = Bench::of(c887());
            to_safe_operational(&mut bench);
        }
        let mut frame = frames[random.below(frames.len())].clone();
        for _ in 0..random.below(6) {
            let place = random.below(frame.len());
            frame[place] = random.next() as u8;
        }
        frame.truncate(frame.len() - if random.below(4) == 0 { random.below(frame.len()) } else { 0 });
        pass(&mut bench, &mut frame);
    }
}
