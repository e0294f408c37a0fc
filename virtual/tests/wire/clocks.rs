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
    assert_eq!(bench.wire.subdevices()[0].sync0_cycle(), None);
    write(&mut bench, 0, 0x0981, &[0x03]);
    assert_eq!(bench.wire.subdevices()[0].sync0_cycle(), Some(Duration::from_millis(1)));
    assert_eq!(u64::from_le_bytes(read(&mut bench, 0, 0x0990)), start);
    bench.wait(Duration::from_millis(25));
    let next = u64::from_le_bytes(read(&mut bench, 0, 0x0990));
    let now = u64::from_le_bytes(read(&mut bench, 0, 0x0910));
    assert_eq!((next - start) % 1_000_000, 0);
    assert!(next > now - 200_000 && next - now < 1_000_000, "{next} after {now}");
}
