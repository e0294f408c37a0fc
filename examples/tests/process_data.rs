//! What the examples of process data say is what the manual and the mapping ask for.

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
