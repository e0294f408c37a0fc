//! Start-up lists, which devc derives, against the steps and the example of the manual.

use devc::model::{Configuration, SdoWrite};
use devc_tests::manual::{Member, s700};

use crate::{departs, device, number, rows};

/// Rows of the example whose index has lost a digit, by row and printed index.
const MISPRINTED: [((usize, &str), &str); 9] = [
    ((3, "0xA00"), "0x1A00"),
    ((4, "0xA00"), "0x1A00"),
    ((5, "0xA00"), "0x1A00"),
    ((6, "0xA00"), "0x1A00"),
    ((11, "0xC12"), "0x1C12"),
    ((12, "0xC12"), "0x1C12"),
    ((13, "0xC13"), "0x1C13"),
    ((13, "0xA00"), "0x1A00, data"),
    ((14, "0xC13"), "0x1C13"),
];

fn configuration(member: Member, id: &str) -> Option<&'static Configuration> {
    device(member).configurations.iter().find(|configuration| configuration.id == id)
}

fn number_of(write: &SdoWrite) -> u32 {
    write.data.iter().rev().fold(0, |high, byte| high << 8 | u32::from(*byte))
}

/// How a configurator prints the index and the data of a write.
fn printed(number: u32) -> String {
    format!("0x{number:02X}")
}

#[test]
fn the_example_comes_out_byte_for_byte() {
    for member in [Member::S300, Member::S700] {
        let startup = &configuration(member, "free-mapping").expect("it is described").startup;
        let rows = rows::<s700::Startup>();
        assert_eq!(startup.len(), rows.len());
        for (write, row) in startup.iter().zip(&rows) {
            let bytes = match (row.index, row.sub) {
                (0x1600 | 0x1A00, 1..) => 4,
                (0x1C12 | 0x1C13, 1..) => 2,
                _ => 1,
            };
            let data = row.value.to_le_bytes()[..bytes].to_vec();
            assert_eq!(write.transition, row.transition, "{row:?}");
            assert_eq!((write.address.index.0, write.address.subindex), (row.index, row.sub), "{row:?}");
            assert_eq!(write.data, data, "{row:?}");
        }
    }
}

#[test]
fn the_example_is_as_printed_but_for_lost_digits() {
    let startup = &configuration(Member::S700, "free-mapping").expect("it is described").startup;
    let mut other = Vec::new();
    for ((place, write), row) in (1..).zip(startup).zip(rows::<s700::Startup>()) {
        if printed(write.address.index.0.into()) != row.printed {
            other.push((place, row.printed));
        }
        if printed(number_of(write)) != row.data {
            other.push((place, row.data));
        }
    }
    departs(other, MISPRINTED);
}

#[test]
fn only_two_members_map_freely() {
    for member in [Member::S400, Member::S600] {
        assert_eq!(configuration(member, "free-mapping"), None);
    }
}

#[test]
fn a_fixed_mapping_is_chosen_in_the_steps_of_the_manual() {
    let steps: Vec<_> =
        rows::<s700::MappingStep>().into_iter().filter(|row| row.mapping == "fixed").collect();
    for member in crate::MEMBERS {
        let startup = &configuration(member, "position").expect("it is described").startup;
        let described: Vec<_> = startup
            .iter()
            .map(|write| (write.address.index.0, Some(write.address.subindex), Some(number_of(write))))
            .collect();
        let printed: Vec<_> =
            steps.iter().map(|step| (step.index, step.sub, step.data.map(u32::from))).collect();
        assert_eq!(described, printed, "{member:?}");
    }
}

/// Where a start-up list does what a step of the free mapping asks for.
fn places(startup: &[SdoWrite], step: &s700::MappingStep) -> Vec<usize> {
    let does = |write: &SdoWrite| {
        write.address.index.0 == step.index
            && step.sub.is_none_or(|sub| sub == write.address.subindex)
            && step.data.is_none_or(|data| u32::from(data) == number_of(write))
    };
    startup.iter().enumerate().filter(|(_, write)| does(write)).map(|(place, _)| place).collect()
}

#[test]
fn the_free_mapping_takes_its_steps_in_order() {
    let startup = &configuration(Member::S700, "free-mapping").expect("it is described").startup;
    let mut before = None;
    for number in 1..=3 {
        let of = |row: &s700::MappingStep| row.mapping == "free" && row.step == number;
        let steps = rows::<s700::MappingStep>().into_iter().filter(of);
        let places: Vec<_> = steps.map(|step| places(startup, &step)).collect();
        assert!(places.iter().all(|places| !places.is_empty()), "step {number} is left out");
        let places: Vec<_> = places.into_iter().flatten().collect();
        assert!(before < places.iter().min().copied(), "step {number} comes too early");
        before = places.into_iter().max();
    }
}

#[test]
fn the_example_has_the_cycle_time_of_its_chapter() {
    let configuration = configuration(Member::S700, "free-mapping").expect("it is described");
    assert_eq!(
        configuration.cycle_time.map(|time| time.0),
        Some(u64::from(number("cycle-example-ms")) * 1_000_000)
    );
    let of = |subindex| {
        let mut writes = configuration.startup.iter();
        let found =
            writes.find(|write| (write.address.index.0, write.address.subindex) == (0x60C2, subindex));
        found.map(|write| write.data.clone())
    };
    assert_eq!(of(1), Some(vec![2]));
    assert_eq!(of(2), Some((-3_i8).to_le_bytes().to_vec()));
}
