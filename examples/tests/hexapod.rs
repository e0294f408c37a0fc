//! The hexapod arrives where the control program has sent it, over the wire.

#![cfg(test)]

use std::process::Command;

#[test]
fn all_six_axes_are_homed_and_moved() {
    let run = Command::new(env!("CARGO_BIN_EXE_hexapod")).output();
    let output = run.map(|run| String::from_utf8_lossy(&run.stdout).into_owned()).unwrap_or_default();
    let order = ["master  Operational", "homing Running", "homing Completed", "drive   X"];
    let places = order.map(|what| output.find(what));
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{output}");
    // 5, -3, 2 mm and 1.5, -1, 4 degrees in steps of 1/100000 (C887T0011, p. 14)
    let ends =
        [("X", 500_000), ("Y", -300_000), ("Z", 200_000), ("U", 150_000), ("V", -100_000), ("W", 400_000)];
    for (axis, steps) in ends {
        let line = format!("drive   {axis} is at {steps} steps, operation enabled, in mode 8\n");
        assert!(output.contains(&line), "{output}");
    }
}
