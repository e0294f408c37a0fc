//! Distributed clocks, against ETG.1000.4, distributed clocks.

use std::time::Duration;

use crate::devices::{Device, all};
use crate::master::*;

fn three() -> Bench {
    let mut bench = Bench::new(all().into_iter().take(3).map(Device::subdevice).collect());
    for position in 0..3_u16 {
        bench.send(APWR, position.wrapping_neg(), 0x0010, &(STATION + position).to_le_bytes());
    }
    bench
}

fn read<const N: usize>(bench: &mut Bench, position: u16, register: u16) -> [u8; N] {
    let answer = bench.send(FPRD, STATION + position, register, &[0; N]);
    assert_eq!(answer.counter, 1);
    answer.data.try_into().unwrap()
}

fn write(bench: &mut Bench, position: u16, register: u16, data: &[u8]) {
    assert_eq!(bench.send(FPWR, STATION + position, register, data).counter, 1);
}

/// Sets the clocks as a master does: from the times at which a frame passed each port, to a time of its own.
fn set(bench: &mut Bench, epoch: u64) -> Vec<u32> {
    assert_eq!(bench.send(BWR, 0, 0x0900, &[0; 4]).counter, 3);
    let mut delays: Vec<u32> = Vec::new();
    let mut behind: Vec<u32> = Vec::new();
    for position in 0..3 {
        let ports: [u8; 8] = read(bench, position, 0x0900);
        let [first, second] = [0, 4].map(|place| u32::from_le_bytes(*ports[place..].first_chunk().unwrap()));
        behind.push(if position == 2 { 0 } else { second.wrapping_sub(first) });
        let before = delays.last().copied().unwrap_or(0);
        let hop = if position == 0 {
            0
        } else {
            (behind[usize::from(position) - 1] - behind[usize::from(position)]) / 2
        };
        delays.push(before + hop);
    }
    for (position, delay) in (0..3).zip(&delays) {
        let received = u64::from_le_bytes(read(bench, position, 0x0918));
        write(bench, position, 0x0920, &epoch.wrapping_sub(received).to_le_bytes());
        write(bench, position, 0x0928, &delay.to_le_bytes());
    }
    delays
}

#[test]
fn delays_grow_from_one_to_the_next() {
    let mut bench = three();
    let delays = set(&mut bench, 0);
    assert_eq!(delays[0], 0);
    assert!(delays[1] > 0 && delays[2] > delays[1], "{delays:?}");
}

/// The clocks begin apart. After offsets and delays are set, the first one's time is given to all, and they follow it.
#[test]
fn clocks_follow_the_first() {
    let mut bench = three();
    let times = |bench: &mut Bench| {
        let datagrams: Vec<_> = (0..3).map(|n| Datagram::new(FPRD, STATION + n, 0x0910, &[0; 8])).collect();
        let answers = bench.all(&datagrams);
        answers
            .iter()
            .map(|answer| u64::from_le_bytes(*answer.data.first_chunk().unwrap()))
            .collect::<Vec<_>>()
    };
    let apart = times(&mut bench);
    assert!(apart[1].abs_diff(apart[0]) > 1_000_000);
    let epoch = 800_000_000_000_000_000;
    let delays = set(&mut bench, epoch);
    // one that is wrong by 10 µs is brought to the others
    let offset = u64::from_le_bytes(read(&mut bench, 2, 0x0920));
    write(&mut bench, 2, 0x0920, &offset.wrapping_add(10_000).to_le_bytes());
    assert_eq!(bench.send(FRMW, STATION, 0x0910, &[0; 8]).counter, 3);
    let difference = u32::from_le_bytes(read(&mut bench, 2, 0x092C));
    assert!((9_000..20_000).contains(&(difference & 0x7FFF_FFFF)), "{difference}");
    for _ in 0..100 {
        assert_eq!(bench.send(FRMW, STATION, 0x0910, &[0; 8]).counter, 3);
    }
    for position in 1..3 {
        assert!(u32::from_le_bytes(read(&mut bench, position, 0x092C)) & 0x7FFF_FFFF < 10);
    }
    let together = times(&mut bench);
    assert!(together[0] > epoch);
    for (time, delay) in together.iter().zip(&delays) {
        assert!((time - u64::from(*delay)).abs_diff(together[0]) < 10, "{together:?}");
    }
    let later = {
        bench.wait(Duration::from_millis(5));
        times(&mut bench)
    };
    assert_eq!(later[0] - together[0], 5_100_000, "time goes on as it does");
}

/// While SYNC0 is active, the start time tells the next pulse: the first, and whole cycles from there on.
#[test]
fn sync0_comes_at_whole_cycles() {
    let mut bench = three();
    set(&mut bench, 0);
    let now = u64::from_le_bytes(read(&mut bench, 0, 0x0910));
    let start = now + 10_000_000;
    write(&mut bench, 0, 0x0990, &start.to_le_bytes());
    write(&mut bench, 0, 0x09A0, &1_000_000_u32.to_le_bytes());
    assert_eq!(bench.wire.subdevices()[0].clocks().sync0, None);
    write(&mut bench, 0, 0x0981, &[0x03]);
    assert_eq!(bench.wire.subdevices()[0].clocks().sync0, Some(Duration::from_millis(1)));
    assert_eq!(u64::from_le_bytes(read(&mut bench, 0, 0x0990)), start);
    bench.wait(Duration::from_millis(25));
    let next = u64::from_le_bytes(read(&mut bench, 0, 0x0990));
    let now = u64::from_le_bytes(read(&mut bench, 0, 0x0910));
    assert_eq!((next - start) % 1_000_000, 0);
    assert!(next > now - 200_000 && next - now < 1_000_000, "{next} after {now}");
}

/// Sets both signals, and tells the start: a time after now.
fn signals(bench: &mut Bench, delay: u64, cycles: [u32; 2]) -> u64 {
    let now = u64::from_le_bytes(read(bench, 0, 0x0910));
    let start = now + delay;
    write(bench, 0, 0x0990, &start.to_le_bytes());
    write(bench, 0, 0x09A0, &cycles[0].to_le_bytes());
    write(bench, 0, 0x09A4, &cycles[1].to_le_bytes());
    write(bench, 0, 0x0981, &[0x07]);
    start
}

/// The next pulses of SYNC0 and SYNC1, the activation status, and the time when they were read.
fn next(bench: &mut Bench) -> ([u64; 2], u8, u64) {
    let registers = [(0x0990, 8), (0x0998, 8), (0x0984, 1), (0x0910, 8)];
    let ask = registers.map(|(register, length)| Datagram::new(FPRD, STATION, register, &vec![0; length]));
    let told = bench.all(&ask);
    let long = |answer: &Datagram| u64::from_le_bytes(*answer.data.first_chunk().unwrap());
    ([long(&told[0]), long(&told[1])], told[2].data[0], long(&told[3]))
}

/// SYNC1 follows a pulse of SYNC0 after its cycle time; while it is due, those of SYNC0 in between have none. So with
/// SYNC0 every 500 µs, 0, 200, 500, 700 and 1500 µs make one of every 1, 1, 2, 2 and 4 pulses.
#[test]
fn sync1_follows_sync0() {
    for (delay, every) in [(0, 1), (200_000, 1), (500_000, 2), (700_000, 2), (1_500_000, 4)] {
        let mut bench = three();
        let start = signals(&mut bench, 10_000_000, [500_000, delay]);
        assert_eq!((next(&mut bench).0, next(&mut bench).1), ([start, start + u64::from(delay)], 0x03));
        bench.wait(Duration::from_millis(20));
        let period = every * 500_000;
        for _ in 0..20 {
            let ([sync0, sync1], status, now) = next(&mut bench);
            assert_eq!((sync0 - start) % 500_000, 0);
            assert_eq!((sync1 - start - u64::from(delay)) % period, 0, "{delay}");
            assert!(sync0 > now && sync0 <= now + 500_000 && sync1 > now && sync1 <= now + period, "{delay}");
            assert_eq!(status, 0);
            bench.wait(Duration::from_micros(130));
        }
        let clocks = bench.wire.subdevices()[0].clocks();
        assert_eq!(clocks.sync1, Some(Duration::from_nanos(period)));
        write(&mut bench, 0, 0x0981, &[0]);
        assert!(!bench.wire.subdevices()[0].clocks().are_active());
    }
}

/// A cycle time of 0: one pulse of each, and no more.
#[test]
fn a_single_shot_comes_once() {
    let mut bench = three();
    let start = signals(&mut bench, 5_000_000, [0, 300_000]);
    assert_eq!(next(&mut bench), ([start, start + 300_000], 0x03, next(&mut bench).2 - 100_000));
    let clocks = bench.wire.subdevices()[0].clocks();
    assert_eq!((clocks.sync0, clocks.sync1), (Some(Duration::ZERO), Some(Duration::ZERO)));
    bench.wait(Duration::from_micros(4_400));
    assert_eq!(next(&mut bench).1, 0x02, "SYNC1 is still to come");
    bench.wait(Duration::from_millis(1));
    let ([sync0, sync1], status, now) = next(&mut bench);
    assert_eq!((sync0, sync1, status), (start, 0, 0));
    assert!(now > start);
}

#[test]
fn a_start_in_the_past_is_missed() {
    let mut bench = three();
    signals(&mut bench, 0, [1_000_000, 0]);
    assert_eq!(next(&mut bench).1, 0x07, "both are pending, and the start is not plausible");
    assert!(bench.wire.subdevices()[0].clocks().are_missed);
    // switched off and on again with a start to come
    write(&mut bench, 0, 0x0981, &[0]);
    signals(&mut bench, 5_000_000, [1_000_000, 0]);
    assert_eq!(next(&mut bench).1, 0x03);
    assert!(!bench.wire.subdevices()[0].clocks().are_missed);
}

/// Bit 3 of 0x0981: the start time activates what is asked for.
#[test]
fn the_start_time_can_activate() {
    let mut bench = three();
    write(&mut bench, 0, 0x09A0, &1_000_000_u32.to_le_bytes());
    write(&mut bench, 0, 0x0981, &[0x0A]);
    assert_eq!(bench.wire.subdevices()[0].clocks().sync0, None);
    let start = u64::from_le_bytes(read(&mut bench, 0, 0x0910)) + 3_000_000;
    write(&mut bench, 0, 0x0990, &start.to_le_bytes());
    assert_eq!(bench.wire.subdevices()[0].clocks().sync0, Some(Duration::from_millis(1)));
    assert_eq!(read(&mut bench, 0, 0x0981), [0x0B]);
}

/// Latch 0 at 0x09B0 and 0x09B8, latch 1 at 0x09C0 and 0x09C8; status 0x09AE and 0x09AF, control 0x09A8 and 0x09A9.
#[test]
fn latches_keep_the_time_of_an_edge() {
    for (latch, times) in [(0_u16, [0x09B0, 0x09B8]), (1, [0x09C0, 0x09C8])] {
        let mut bench = three();
        set(&mut bench, 1_000_000_000);
        let edge = |bench: &mut Bench, is_high| {
            let now = u64::from_le_bytes(read(bench, 0, 0x0910));
            bench.wire.subdevices_mut()[0].latch(latch, is_high);
            // reading the time took a frame of 100 µs
            now + 100_000
        };
        let status = |bench: &mut Bench| read::<1>(bench, 0, 0x09AE + latch)[0];
        let event = |bench: &mut Bench| read::<2>(bench, 0, 0x0210)[0] & 0x01;
        assert_eq!((status(&mut bench), event(&mut bench)), (0, 0));
        let rising = edge(&mut bench, true);
        assert_eq!((status(&mut bench), event(&mut bench)), (0x05, 1), "a rising edge, and the level");
        assert_eq!(u64::from_le_bytes(read(&mut bench, 0, times[0])), rising);
        assert_eq!((status(&mut bench), event(&mut bench)), (0x04, 0), "its time was read");
        let falling = edge(&mut bench, false);
        assert_eq!(status(&mut bench), 0x02);
        assert_eq!(u64::from_le_bytes(read(&mut bench, 0, times[1])), falling);
        // continuous: the last edge counts
        edge(&mut bench, true);
        edge(&mut bench, false);
        let last = edge(&mut bench, true);
        assert_eq!(u64::from_le_bytes(read(&mut bench, 0, times[0])), last);
        // single: the first, until it was read
        write(&mut bench, 0, 0x09A8 + latch, &[0x01]);
        edge(&mut bench, false);
        let first = edge(&mut bench, true);
        edge(&mut bench, false);
        edge(&mut bench, true);
        assert_eq!(u64::from_le_bytes(read(&mut bench, 0, times[0])), first);
        edge(&mut bench, false);
        let next = edge(&mut bench, true);
        assert_eq!(u64::from_le_bytes(read(&mut bench, 0, times[0])), next);
        assert_eq!(status(&mut bench) & 0x04, 0x04);
    }
}
