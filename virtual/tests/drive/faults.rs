//! What stops a drive: quick stop, faults, following errors, and the way out of them.

use crate::bench::{Bench, device, devices};

#[test]
fn commands_lead_up_and_down() {
    for device in devices() {
        let mut bench = Bench::operational(device);
        bench.all_show("switch-on-disabled");
        bench.enable();
        for (word, state) in
            [(0x07, "switched-on"), (0x06, "ready-to-switch-on"), (0x00, "switch-on-disabled")]
        {
            bench.command(word);
            bench.all_show(state);
        }
    }
}

#[test]
fn a_quick_stop_ends_as_the_description_says() {
    for (id, end) in
        [("c887", "quick-stop-active"), ("s700", "quick-stop-active"), ("double", "switch-on-disabled")]
    {
        let device = device(id);
        let mut bench = Bench::operational(device);
        bench.enable();
        // bit 2 falls, and what enables stays
        bench.command(0x0B);
        bench.cycles(30);
        bench.all_show(end);
    }
}

#[test]
fn quick_stop_active_is_kept_where_an_option_says_so() {
    let device = device("single");
    let mut bench = Bench::operational(device);
    bench.set(bench.on(0, 0x605A, 0), 6);
    bench.enable();
    bench.command(0x0B);
    bench.cycles(30);
    bench.all_show("quick-stop-active");
}

#[test]
fn a_fault_is_told_and_reset() {
    for device in devices() {
        for axis in 0..device.axes.len() {
            let mut bench = Bench::operational(device);
            bench.enable();
            bench.drive.fault(axis, 0x7121);
            bench.cycles(20);
            assert!(bench.shows(axis, "fault"), "{}, axis {axis}", device.name);
            let others_too = device.id == "c887";
            for other in bench.axes().filter(|other| *other != axis) {
                assert_eq!(bench.shows(other, "fault"), others_too, "{}, axis {other}", device.name);
            }
            // CiA 301: generic and manufacturer-specific; C887T0011, p. 19, has the same
            assert_eq!(bench.emergencies(), [(0x7121, 0x81)], "{}", device.name);
            assert_eq!(bench.drive.axes()[axis].error, 0x7121);
            if bench.has(axis, 0x603F, 0) {
                assert_eq!(bench.get(bench.on(axis, 0x603F, 0)), 0x7121, "{}", device.name);
            }
            bench.command(0x00);
            bench.command(0x80);
            bench.command(0x00);
            bench.all_show("switch-on-disabled");
            assert_eq!(bench.emergencies(), [(0, 0)], "{}", device.name);
            assert_eq!(bench.drive.axes()[axis].error, 0);
            bench.enable();
        }
    }
}

#[test]
fn what_the_c887_does_not_allow_is_a_fault() {
    let device = device("c887");
    // C887T0011, p. 12: a command that the state does not permit
    let mut bench = Bench::operational(device);
    bench.command(0x06);
    bench.command(0x0F);
    bench.cycles(10);
    bench.all_show("fault");
    assert_eq!(bench.emergencies(), [(0x6320, 0x81)]);
    // p. 11: a mode that it does not have
    let mut bench = Bench::operational(device);
    bench.enable();
    bench.set(bench.on(0, 0x6060, 0), 9);
    bench.cycles(10);
    bench.all_show("fault");
    // while the Pilz drive ignores both
    let device = crate::bench::device("single");
    let mut bench = Bench::operational(device);
    bench.command(0x06);
    bench.command(0x0F);
    bench.all_show("ready-to-switch-on");
}

#[test]
fn an_axis_that_is_held_has_a_following_error() {
    // CiA 402: larger than the window for longer than the time
    let device = device("double");
    let mut bench = Bench::operational(device);
    for axis in bench.axes() {
        bench.set(bench.on(axis, 0x6065, 0), 1000);
        bench.set(bench.on(axis, 0x6066, 0), 20);
    }
    bench.select(8);
    bench.enable();
    bench.drive.hold(1, true);
    for axis in bench.axes() {
        bench.set(bench.on(axis, 0x607A, 0), 5000);
    }
    bench.cycles(15);
    assert_eq!(bench.get(bench.on(1, 0x60F4, 0)), 5000);
    assert!(bench.shows(1, "operation-enabled"));
    bench.cycles(20);
    assert!(bench.shows(0, "operation-enabled") && bench.shows(1, "fault"));
    assert_eq!(bench.get(bench.on(0, 0x6064, 0)), 5000);
    assert_eq!(bench.emergencies(), [(0x8611, 0x21)]);
}

#[test]
fn a_device_without_a_window_shows_the_error_of_an_axis_that_is_held() {
    let device = device("c887");
    let mut bench = Bench::operational(device);
    bench.enable();
    bench.select(8);
    bench.drive.hold(2, true);
    for axis in bench.axes() {
        bench.set(bench.on(axis, 0x607A, 0), 100);
    }
    bench.cycles(20);
    for axis in bench.axes() {
        assert_eq!(bench.statusword(axis) & 1 << 13 != 0, axis == 2, "axis {axis}");
    }
    bench.all_show("operation-enabled");
    bench.drive.hold(2, false);
    bench.cycles(20);
    assert_eq!(bench.statusword(2) & 1 << 13, 0);
}
