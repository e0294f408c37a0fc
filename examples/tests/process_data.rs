//! What the examples of process data and of units say is what the manuals and the mapping ask for.

#![cfg(test)]

use std::process::Command;

fn output(program: &str) -> String {
    let run = Command::new(program).output();
    run.map(|run| String::from_utf8_lossy(&run.stdout).into_owned()).unwrap_or_default()
}

#[test]
fn the_free_mapping_is_written_before_it_is_assigned() {
    let output = output(env!("CARGO_BIN_EXE_free_mapping"));
    let place = |write: &str| output.lines().position(|line| line.trim().starts_with(write));
    let writes = ["0x1C12:00 = 0x00", "0x1600:02 = 0x60C10020", "0x1600:00 = 0x02", "0x1C12:01 = 0x1600"];
    let places = writes.map(place);
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{places:?} in {output}");
    assert!(output.contains("packed: [0F, 00, 18, FC, FF, FF]"), "{output}");
    assert!(output.contains("moved in place: [0F, 00, E8, 03, 00, 00]"), "{output}");
}

#[test]
fn every_axis_is_told_where_it_is() {
    let output = output(env!("CARGO_BIN_EXE_in_ethercrab"));
    let lines = output.lines().filter_map(|line| line.strip_prefix("is at "));
    let pairs: Vec<_> = lines.filter_map(|line| line.split_once(", is told ")).collect();
    assert_eq!(pairs.len(), 6, "{output}");
    assert!(pairs.iter().all(|(at, told)| at == told), "{output}");
    // bytes 3 to 6 of the inputs of the first axis, which count up
    assert!(pairs.first().is_some_and(|(at, _)| *at == 0x0605_0403.to_string()), "{output}");
}

/// C887T0011, p. 14: 0x5000 counts micrometres and thousandths of a degree, positions 1/100 000 mm and 1/100 000 degree.
#[test]
fn lengths_and_angles_have_the_numbers_of_their_entries() {
    let output = output(env!("CARGO_BIN_EXE_units"));
    let written = |address: &str| {
        let (_, bytes) = output.split_once(&format!("{address} = ["))?;
        let bytes = bytes.split(']').next()?.split(", ").map(|byte| u8::from_str_radix(byte, 16));
        Some(i32::from_le_bytes(bytes.collect::<Result<Vec<_>, _>>().ok()?.try_into().ok()?))
    };
    assert_eq!((written("0x5000:01"), written("0x5000:04")), (Some(15_000), Some(-2000)), "{output}");
    assert_eq!((written("0x607D:02"), written("0x887D:02")), (Some(2_250_000), Some(1_500_000)), "{output}");
    assert!(output.contains("Z ends at 0.0225 m\n") && output.contains("U ends at 15 °\n"), "{output}");
}
