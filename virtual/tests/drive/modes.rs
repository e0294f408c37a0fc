//! Set values are followed, on every axis, in each mode that a device has.

use devc::model::{Address, Device, Mode};

use crate::bench::{Bench, device, devices};

/// The set-point of position that a mode has among its objects, on the first axis.
fn target(device: &Device, mode: &Mode) -> (u16, u8) {
    let named = |index: u16| mode.objects.iter().any(|it| it.index.0 == index);
    match (named(0x607A), device.entry(Address { index: devc::model::Index(0x60C1), subindex: 1 })) {
        (true, _) => (0x607A, 0),
        (false, Some(_)) => (0x60C1, 1),
        (false, None) => (0x60C1, 0),
    }
}

/// The position that a mode names among its objects.
fn actual(mode: &Mode) -> u16 {
    mode.objects
        .iter()
        .map(|it| it.index.0)
        .find(|index| [0x6063, 0x6064].contains(index))
        .expect("it has one")
}

/// Devices that have a mode, ready in it.
fn each_with(code: i16, mut check: impl FnMut(&mut Bench, &Mode)) {
    let mut count = 0;
    for device in devices() {
        let Some(mode) = device.modes.iter().find(|mode| mode.code == code) else { continue };
        count += 1;
        let codes = std::iter::once(mode.code).chain(mode.aliases.iter().copied());
        for code in codes {
            let mut bench = Bench::operational(device);
            bench.enable();
            bench.select(code);
            check(&mut bench, mode);
        }
    }
    assert!(count > 0, "some device has mode {code}");
}

fn follows_positions(bench: &mut Bench, mode: &Mode) {
    let (index, subindex) = target(bench.device, mode);
    for step in 1..=100 {
        for axis in bench.axes() {
            bench.set(bench.on(axis, index, subindex), step * (axis as i64 * 10 - 25));
        }
        bench.cycle();
    }
    for axis in bench.axes() {
        // on its way, and a little behind
        let (position, end) = (bench.get(bench.on(axis, actual(mode), 0)), 100 * (axis as i64 * 10 - 25));
        assert!(position.abs() > end.abs() / 2 && (position - end).abs() < 100, "{position} of {end}");
    }
    bench.cycles(30);
    for axis in bench.axes() {
        let end = 100 * (axis as i64 * 10 - 25);
        assert_eq!(bench.get(bench.on(axis, actual(mode), 0)), end, "{}, axis {axis}", bench.device.name);
        if bench.has(axis, 0x60F4, 0) {
            assert_eq!(bench.get(bench.on(axis, 0x60F4, 0)), 0);
        }
    }
}

#[test]
fn cyclic_positions_are_followed() {
    each_with(8, |bench, mode| {
        follows_positions(bench, mode);
        let status = mode.status_bits.iter().any(|field| field.low == 12);
        for axis in bench.axes() {
            assert_eq!(bench.statusword(axis) & 1 << 12 != 0, status, "{}", bench.device.name);
        }
    });
}

#[test]
fn interpolated_positions_are_followed_once_that_is_enabled() {
    each_with(7, |bench, mode| {
        bench.set(bench.on(0, 0x60C1, 1), 500);
        bench.cycles(10);
        assert_eq!(bench.get(bench.on(0, 0x6064, 0)), 0);
        assert_eq!(bench.statusword(0) & 1 << 12, 0);
        bench.set(bench.on(0, 0x60C1, 1), 0);
        bench.command(0x1F);
        follows_positions(bench, mode);
        assert_ne!(bench.statusword(0) & 1 << 12, 0);
    });
}

/// The velocity that an axis has by two positions, in steps of the position in a second.
fn measured(bench: &mut Bench, axis: usize) -> f64 {
    let before = bench.drive.axes()[axis].position;
    bench.cycles(100);
    (bench.drive.axes()[axis].position - before) * 10.0
}

fn follows_velocities(bench: &mut Bench, target: u16, actual: u16) {
    for axis in bench.axes() {
        bench.set(bench.on(axis, target, 0), 3000 - 4500 * axis as i64);
    }
    bench.cycles(200);
    for axis in bench.axes() {
        let wanted = 3000 - 4500 * axis as i64;
        assert_eq!(bench.get(bench.on(axis, actual, 0)), wanted, "{}, axis {axis}", bench.device.name);
        // no description says how many steps of position a step of velocity is: it counts as one
        assert!((measured(bench, axis) - wanted as f64).abs() < 1.0, "{}", bench.device.name);
    }
}

#[test]
fn cyclic_velocities_are_followed() {
    each_with(9, |bench, _| follows_velocities(bench, 0x60FF, 0x606C));
}

#[test]
fn profile_velocities_are_reached_with_their_acceleration() {
    each_with(3, |bench, _| {
        for axis in bench.axes() {
            bench.set(bench.on(axis, 0x6083, 0), 30_000);
            bench.set(bench.on(axis, 0x60FF, 0), 3000);
        }
        bench.cycles(50);
        // half of the way up: 30000 in a second, for 50 ms
        let half = bench.get(bench.on(0, 0x606C, 0));
        assert!((1200..1600).contains(&half), "{half}");
        assert_eq!(bench.statusword(0) & 1 << 10, 0);
        bench.cycles(100);
        assert_ne!(bench.statusword(0) & 1 << 10, 0);
        follows_velocities(bench, 0x60FF, 0x606C);
    });
}

#[test]
fn velocity_mode_follows_its_three_bits() {
    each_with(2, |bench, _| {
        for axis in bench.axes() {
            bench.set(bench.on(axis, 0x6042, 0), 3000);
        }
        bench.command(0x0F);
        assert_eq!(bench.get(bench.on(0, 0x6044, 0)), 0);
        bench.command(0x7F);
        follows_velocities(bench, 0x6042, 0x6044);
        // 1005347, table 17: bit 5 keeps the velocity, bits 4 and 6 let it be 0
        bench.command(0x5F);
        bench.set(bench.on(0, 0x6042, 0), 100);
        bench.cycles(50);
        assert_eq!(bench.get(bench.on(0, 0x6044, 0)), 3000);
        bench.command(0x6F);
        bench.cycles(50);
        assert_eq!(bench.get(bench.on(0, 0x6044, 0)), 0);
    });
}

#[test]
fn torques_are_followed_and_turn_the_axis() {
    for code in [4, 10] {
        each_with(code, |bench, _| {
            for axis in bench.axes() {
                bench.set(bench.on(axis, 0x6071, 0), 200 - 300 * axis as i64);
            }
            bench.cycles(400);
            for axis in bench.axes() {
                let wanted = 200 - 300 * axis as i64;
                assert_eq!(bench.get(bench.on(axis, 0x6077, 0)), wanted, "{}", bench.device.name);
                assert!(bench.drive.axes()[axis].velocity * wanted as f64 > 0.0, "{}", bench.device.name);
            }
        });
    }
}

#[test]
fn set_points_are_handed_over() {
    each_with(1, |bench, _| {
        for axis in bench.axes() {
            bench.set(bench.on(axis, 0x6081, 0), 10_000);
            bench.set(bench.on(axis, 0x6083, 0), 100_000);
            bench.set(bench.on(axis, 0x607A, 0), 1000);
        }
        let shown = |bench: &mut Bench| bench.statusword(0) & 0x1400;
        bench.command(0x1F);
        assert_eq!(shown(bench), 0x1000, "taken, and on its way");
        bench.command(0x0F);
        assert_eq!(shown(bench), 0x0000, "ready for the next");
        // a second one, which waits for the first, relative to it
        bench.set(bench.on(0, 0x607A, 0), 500);
        bench.command(0x5F);
        bench.command(0x0F);
        assert_eq!(shown(bench), 0x1000, "no third one yet");
        // 0.1 s up to 10000 in a second and 0.1 s down are 1000 steps; 500 take 2 × sqrt(500 / 100000) s, which is 0.14
        bench.cycles(350);
        assert_eq!(bench.get(bench.on(0, 0x6064, 0)), 1500);
        assert_eq!(shown(bench), 0x0400);
        // at once, and back
        bench.set(bench.on(0, 0x607A, 0), 9000);
        bench.command(0x3F);
        bench.command(0x0F);
        bench.set(bench.on(0, 0x607A, 0), -700);
        bench.command(0x3F);
        bench.command(0x0F);
        assert_eq!(shown(bench), 0x0000);
        bench.cycles(600);
        assert_eq!((bench.get(bench.on(0, 0x6064, 0)), shown(bench)), (-700, 0x0400));
        if bench.device.axes.len() > 1 {
            assert_eq!(bench.get(bench.on(1, 0x6064, 0)), 1000, "the other axis has its own");
        }
    });
}

#[test]
fn a_position_beyond_a_limit_is_not_gone_to() {
    let device = device("single");
    let mut bench = Bench::operational(device);
    bench.set(bench.on(0, 0x607D, 1), -50);
    bench.set(bench.on(0, 0x607D, 2), 100);
    bench.enable();
    bench.select(8);
    bench.set(bench.on(0, 0x607A, 0), 400);
    bench.cycles(30);
    assert_eq!(bench.get(bench.on(0, 0x6064, 0)), 100);
    assert_ne!(bench.statusword(0) & 1 << 11, 0, "internal limit active");
    bench.set(bench.on(0, 0x607A, 0), 60);
    bench.cycles(30);
    assert_eq!((bench.get(bench.on(0, 0x6064, 0)), bench.statusword(0) & 1 << 11), (60, 0));
}

#[test]
fn the_axes_of_the_c887_share_mode_and_state() {
    let device = device("c887");
    let mut bench = Bench::operational(device);
    // C887T0011, p. 11: the bits of the first axis count
    for word in [0x06, 0x07, 0x0F] {
        bench.set(bench.on(0, 0x6040, 0), word);
        bench.cycles(3);
    }
    bench.all_show("operation-enabled");
    bench.set(bench.on(0, 0x6060, 0), 8);
    bench.cycles(3);
    for axis in bench.axes() {
        assert_eq!(bench.get(bench.on(axis, 0x6061, 0)), 8);
    }
    // p. 17: the mode ends with a quick stop
    bench.command(0x0B);
    assert_eq!(bench.get(bench.on(5, 0x6061, 0)), 0);
}

#[test]
fn a_drive_without_power_does_not_move() {
    for device in devices() {
        let mut bench = Bench::operational(device);
        let mode = device.modes.iter().find(|mode| mode.code == 8).expect("it has the mode");
        let (index, subindex) = target(device, mode);
        for axis in bench.axes() {
            bench.set(bench.on(axis, index, subindex), 1000);
        }
        for word in [0x00, 0x06, 0x07] {
            bench.command(word);
            bench.cycles(10);
            assert!(bench.drive.axes().iter().all(|axis| axis.position == 0.0), "{}", device.name);
        }
    }
}

/// The Pilz drives' own mode: bits 4 and 5 move the axis by hand, both of them stop it (6.6.10.2).
#[test]
fn jogging_moves_while_one_bit_is_set() {
    each_with(-1, |bench, _| {
        for axis in bench.axes() {
            bench.set(bench.on(axis, 0x6081, 0), 4000);
        }
        for (bits, way) in [(1 << 4, 1.0), (0, 0.0), (1 << 5, -1.0), (0b11 << 4, 0.0)] {
            bench.command(0x0F | bits);
            bench.cycles(100);
            for axis in bench.drive.axes() {
                assert_eq!(
                    axis.velocity.signum() * f64::from(axis.velocity != 0.0),
                    way,
                    "{bits:#x}: {axis:?}"
                );
            }
        }
    });
}
