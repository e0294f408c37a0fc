//! Reference runs, by every method of every device (CiA 402, homing mode).

use devc::model::Way;

use crate::bench::{Bench, devices};

#[test]
fn every_method_sets_the_reference() {
    for device in devices() {
        let mut bench = Bench::operational(device);
        let bits = device.modes.iter().find_map(|mode| mode.homing_bits).expect("it homes");
        let (start, reached, attained) = (1_u16 << bits.start, 1_u16 << bits.reached, 1_u16 << bits.attained);
        bench.enable();
        let methods: Vec<_> =
            device.homing_methods.iter().map(|it| Some((it.number, it.direction))).collect();
        let none = vec![None];
        for method in if methods.is_empty() { none } else { methods } {
            for axis in bench.axes() {
                if let Some((number, _)) = method {
                    bench.set(bench.on(axis, 0x6098, 0), number.into());
                    bench.set(bench.on(axis, 0x607C, 0), 777);
                    bench.set(bench.on(axis, 0x6099, 1), 5000);
                }
            }
            bench.select(6);
            let before: Vec<f64> = bench.drive.axes().iter().map(|axis| axis.position).collect();
            bench.command(0x0F | start);
            bench.cycles(20);
            for axis in bench.axes() {
                let word = bench.statusword(axis);
                assert_eq!(word & (reached | attained), 0, "{}, {method:?}: {word:#06X}", device.name);
                let moved = bench.drive.axes()[axis].position - before[axis];
                let expected = match method.and_then(|(_, direction)| direction) {
                    None => 0.0,
                    Some(Way::Positive) => 1.0,
                    Some(Way::Negative) => -1.0,
                };
                assert!(moved * expected > 0.0 || moved == 0.0 && expected == 0.0, "{method:?}: {moved}");
            }
            bench.cycles(40);
            let offset = if method.is_some() { 777.0 } else { 0.0 };
            for axis in bench.axes() {
                let word = bench.statusword(axis);
                assert_eq!(word & (reached | attained), reached | attained, "{}, {method:?}", device.name);
                assert_eq!(bench.drive.axes()[axis].position, offset, "{}, {method:?}", device.name);
            }
            bench.command(0x0F);
        }
    }
}

#[test]
fn a_run_ends_with_its_start_bit_and_a_method_that_is_none_fails() {
    for device in devices().filter(|device| !device.homing_methods.is_empty()) {
        let mut bench = Bench::operational(device);
        bench.enable();
        bench.set(bench.on(0, 0x6098, 0), 17);
        bench.select(6);
        bench.command(0x1F);
        bench.command(0x0F);
        bench.cycles(20);
        // 1005347, 6.6.9.2: broken off, 001
        assert_eq!(bench.statusword(0) & 0x3400, 0x0400, "{}", device.name);
        bench.set(bench.on(0, 0x6098, 0), 99);
        bench.command(0x1F);
        bench.cycles(20);
        // failed and at rest, 110 in the order 13, 12, 10 is 101 of these bits
        assert_eq!(bench.statusword(0) & 0x3400, 0x2400, "{}", device.name);
    }
}
