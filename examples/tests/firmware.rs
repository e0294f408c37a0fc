//! What the firmware says is what the standard asks for.

#![cfg(test)]

use std::process::Command;

/// The bytes behind the headers of the `number`th answer.
fn sdo(output: &str, number: usize) -> Vec<u8> {
    let mut answers = output.lines().filter_map(|line| line.trim().strip_prefix("device"));
    let answer = answers.nth(number).unwrap_or_default();
    let bytes = answer.split_whitespace().filter_map(|byte| u8::from_str_radix(byte, 16).ok());
    bytes.skip(8).collect()
}

#[test]
fn the_dictionary_is_served() {
    let run = Command::new(env!("CARGO_BIN_EXE_firmware")).output();
    let output = run.map(|run| String::from_utf8_lossy(&run.stdout).into_owned()).unwrap_or_default();
    // 14 characters: eight go with the first message, six with the segment, which says that one byte is not used
    assert_eq!(sdo(&output, 0), [&[0x41, 0x08, 0x10, 0, 14, 0, 0, 0], &b"C-887 Et"[..]].concat());
    assert_eq!(sdo(&output, 1), [&[0x03], &b"herCAT\0"[..]].concat());
    assert_eq!(sdo(&output, 2), [0x43, 0x64, 0x68, 0, 0x38, 0xFF, 0xFF, 0xFF]);
    assert_eq!(sdo(&output, 3), [0x60, 0x10, 0x50, 1, 0, 0, 0, 0]);
    assert!(output.contains("the firmware moves the origin to [0, 0, 0, 0, 0, 0]"), "{output}");
    assert_eq!(sdo(&output, 4), [0x80, 0x7D, 0x60, 2, 0x36, 0x00, 0x09, 0x06]);
    assert_eq!(sdo(&output, 5), [0x80, 0x64, 0x90, 0, 0x00, 0x00, 0x02, 0x06]);
    assert_eq!(sdo(&output, 6), [0x80, 0x40, 0x60, 0, 0x12, 0x00, 0x07, 0x06]);
    assert_eq!(sdo(&output, 7), [0x60, 0x40, 0x60, 0, 0, 0, 0, 0]);
    assert!(output.ends_with("X is told to switch on: true\n"), "{output}");
}
