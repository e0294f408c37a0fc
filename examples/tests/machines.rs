//! What the control programs print is what the manuals ask for.

#![cfg(test)]

use std::process::Command;

fn output(program: &str) -> String {
    let run = Command::new(program).output();
    run.map(|run| String::from_utf8_lossy(&run.stdout).into_owned()).unwrap_or_default()
}

/// The numbers of the transitions that lines tell of.
fn transitions(lines: &str) -> Vec<u8> {
    let numbers =
        lines.lines().filter_map(|line| line.split_once("transition ").filter(|_| line.contains(" to ")));
    numbers.filter_map(|(_, rest)| rest.split(',').next()?.parse().ok()).collect()
}

/// C887T0011, p. 10 and 12: all axes make transitions 1 to 4, then the targets are followed without a jump.
#[test]
fn six_axes_are_enabled_as_one_and_follow_the_path() {
    let output = output(env!("CARGO_BIN_EXE_coupled_axes"));
    let drive: Vec<&str> = output.lines().filter(|line| line.starts_with("drive")).collect();
    assert_eq!(transitions(&drive.join("\n")), [1, 2, 3, 4], "{output}");
    // 2π × 5 mm in 1000 cycles, in the middle twice as fast
    let widest =
        output.split_once("the widest step ").and_then(|(_, rest)| rest.split(' ').next()?.parse().ok());
    assert_eq!(widest, Some(62.8), "{output}");
    assert!(output.ends_with("back within 0 µm\n"), "{output}");
}

/// C887T0011, p. 12 and 18: 13 and 14, then nothing but a fault reset leads on, and that to switch on disabled.
#[test]
fn a_fault_is_explained_and_ends_only_when_asked() {
    let output = output(env!("CARGO_BIN_EXE_fault"));
    let parts =
        ["a motor is blocked", "the motor is free again", "asked for a reset", "asked for operation\n"];
    let mut rest = output.as_str();
    let mut made = Vec::new();
    for part in parts {
        let (before, after) = rest.split_once(part).unwrap_or((rest, ""));
        made.push(transitions(before));
        rest = after;
    }
    made.push(transitions(rest));
    assert_eq!(made, [vec![1, 2, 3, 4], vec![13, 14], vec![], vec![15], vec![2, 3, 4]], "{output}");
    assert!(output.contains("error 0x7121: Motor Blocked\n  register 0x81, vendor codes [657]."), "{output}");
    assert!(output.ends_with("error 0x1234: unknown error\n"), "{output}");
}

/// 1005347, 6.6.9.2, table 26: done with bits 10 and 12, failed with bit 13; each axis for itself.
#[test]
fn one_axis_finds_its_reference_and_the_other_says_that_it_does_not() {
    let output = output(env!("CARGO_BIN_EXE_homing"));
    let (head, axes) = output.split_once("axis A\n").unwrap_or_default();
    let (a, b) = axes.split_once("axis B\n").unwrap_or_default();
    assert!(head.contains("17: Homing on negative limit switch"), "{output}");
    let last = |text: &str| text.lines().last().unwrap_or_default().trim().to_owned();
    assert_eq!(last(a), "Completed at -200 in operation enabled", "{output}");
    assert!(last(b).starts_with("Failed at "), "{output}");
}
