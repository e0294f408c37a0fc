//! Touch probes, after CiA 402 and what the manual of the Pilz drives says of theirs (6.11).

use crate::bench::{Bench, device};

const FUNCTION: u16 = 0x60B8;
const STATUS: u16 = 0x60B9;
/// The positions of a probe: at the rising edge, and at the falling one.
const POSITIONS: [[u16; 2]; 2] = [[0x60BA, 0x60BB], [0x60BC, 0x60BD]];

/// A drive that is led by positions, with a function of both probes on an axis.
fn armed(id: &str, axis: usize, function: i64) -> Bench {
    let mut bench = Bench::operational(device(id));
    bench.select(8);
    for word in [0x06, 0x07, 0x0F] {
        bench.command(word);
    }
    bench.set(bench.on(axis, FUNCTION, 0), function);
    bench.cycles(2);
    bench
}

fn go_to(bench: &mut Bench, axis: usize, position: i64) {
    bench.set(bench.on(axis, 0x607A, 0), position);
    bench.cycles(40);
}

fn status(bench: &mut Bench, axis: usize) -> i64 {
    bench.cycle();
    bench.get(bench.on(axis, STATUS, 0))
}

#[test]
fn each_edge_has_its_position() {
    for (id, axes) in [("double", 2), ("single", 1), ("double-hires", 2), ("single-hires", 1)] {
        for (axis, probe) in (0..axes).flat_map(|axis| [(axis, 0), (axis, 1)]) {
            let mut bench = armed(id, axis, 0x33 << (8 * probe));
            let mut expected = 0x01;
            assert_eq!(status(&mut bench, axis), expected << (8 * probe));
            let mut seen = [0, 0];
            for (step, position) in [1000, -2000, 3000, 4000].into_iter().enumerate() {
                go_to(&mut bench, axis, position);
                let edge = step % 2;
                bench.drive.signal(axis, probe, edge == 0);
                seen[edge] = position;
                expected |= 0x02 << edge;
                assert_eq!(status(&mut bench, axis), expected << (8 * probe), "{id}, {axis}, {probe}");
                let read = POSITIONS[probe].map(|index| bench.get(bench.on(axis, index, 0)));
                assert_eq!(read, seen, "{id}, {axis}, {probe}");
            }
            // bit 0 falls: "all bits of the status go to 0, and the positions stay"
            bench.set(bench.on(axis, FUNCTION, 0), 0);
            assert_eq!(status(&mut bench, axis), 0);
            assert_eq!(bench.get(bench.on(axis, POSITIONS[probe][0], 0)), 3000);
        }
    }
}

#[test]
fn what_is_not_asked_for_is_not_seen() {
    // 0x21: the first falling edge; 0x31: the first event, whichever it is; 0x20 without bit 0: nothing
    for (function, levels, expected) in [
        (0x21, &[true, false, true, false][..], [0, 2]),
        (0x31, &[true, false], [1, 0]),
        (0x11, &[true, false, true], [1, 0]),
        (0x13, &[true, false, true], [3, 0]),
        (0x20, &[true, false], [0, 0]),
        // a mark of the encoder is looked for, and no signal
        (0x37, &[true, false], [0, 0]),
    ] {
        let mut bench = armed("single", 0, function);
        for (position, level) in (1..).zip(levels) {
            go_to(&mut bench, 0, position);
            bench.drive.signal(0, 0, *level);
        }
        bench.cycle();
        let read = POSITIONS[0].map(|index| bench.get(bench.on(0, index, 0)));
        assert_eq!(read, expected, "{function:#x}");
    }
}

#[test]
fn a_probe_that_is_switched_on_again_measures_again() {
    let mut bench = armed("single", 0, 0x11);
    for position in [100, 200] {
        go_to(&mut bench, 0, position);
        bench.drive.signal(0, 0, true);
        bench.cycle();
        assert_eq!(bench.get(bench.on(0, 0x60BA, 0)), position);
        bench.drive.signal(0, 0, false);
        for function in [0x00, 0x11] {
            bench.set(bench.on(0, FUNCTION, 0), function);
            bench.cycles(2);
        }
    }
}

/// The position in thousandths of a millimetre, what the probes measure in hundred-thousandths.
#[test]
fn positions_are_in_the_unit_of_the_description() {
    let mut bench = armed("own", 0, 0x13);
    for (times, position) in (1..).zip([12, -34]) {
        go_to(&mut bench, 0, position);
        bench.drive.signal(0, 0, true);
        bench.drive.signal(0, 0, false);
        bench.cycle();
        assert_eq!(bench.get(bench.on(0, 0x60BA, 0)), position * 100);
        assert_eq!(bench.get(bench.on(0, 0x60D5, 0)), times, "the edges are counted");
    }
}
