//! Tables that are like another one of their section, and entries that are numbered.

#![allow(clippy::expect_used)] // a test may

use std::path::Path;

use devc::model::{Device, Family};
use devc::source::Memory;
use devc_tests::HEAD;

fn family(text: &str) -> Family {
    let loader = Memory::new().with("device.toml", format!("{HEAD}{text}"));
    Family::clone(&devc::compile(&loader, Path::new("")).family.expect("it compiles"))
}

fn device(text: &str) -> Device {
    family(text).members.remove(0)
}

#[test]
fn what_is_not_said_is_that_of_the_other() {
    let device = device(
        r#"
        [objects.0x2000]
        id     = "first"
        name   = "First value"
        type   = "INT16"
        access = "rw"
        note   = "Kept."
        source = "p. 3"

        [objects.0x2001]
        like    = "0x2000"
        without = ["note"]
        name    = "Second value"
        "#,
    );
    let object = |id: &str| device.objects.iter().find(|object| object.id == id).expect("it is described");
    let (first, second) = (object("first"), object("second-value"));
    let (one, other) = (&first.entries[0], &second.entries[0]);
    assert_eq!(second.name, "Second value");
    assert_eq!((one.data_type, one.access), (other.data_type, other.access));
    assert_eq!((first.source.as_ref(), one.note.as_deref()), (second.source.as_ref(), Some("Kept.")));
    assert_eq!(other.note, None);
    assert_eq!(second.source.as_ref().map(|source| source.place.as_str()), Some("p. 3"));
}

#[test]
fn a_member_changes_one_table_and_not_those_like_it() {
    let family = family(
        r#"
        [family]
        name = "Drives"

        [cycle-times.position]
        name = "Position"
        min  = "250 us"

        [cycle-times.velocity]
        like = "position"
        name = "Velocity"

        [members.slow.cycle-times.position]
        min = "1 ms"

        [members.fast.cycle-times.torque]
        like = "velocity"
        name = "Torque"
        "#,
    );
    let times = |id: &str| {
        let member = family.members.iter().find(|member| member.id == id).expect("it is a member");
        member
            .cycle_times
            .iter()
            .map(|time| (time.name.as_str(), time.min.map(|it| it.0)))
            .collect::<Vec<_>>()
    };
    assert_eq!(times("slow"), [("Position", Some(1_000_000)), ("Velocity", Some(250_000))]);
    let fast = [("Position", Some(250_000)), ("Velocity", Some(250_000)), ("Torque", Some(250_000))];
    assert_eq!(times("fast"), fast);
}

#[test]
fn entries_are_numbered_and_found_by_their_parameters() {
    let device = device(
        r#"
        [objects.0x2030]
        name    = "Variables"
        kind    = "array"
        type    = "INT32"
        pdo     = "tx"
        entries = { "1..=3" = { name = "VAR{+8} ({})", parameter = "VAR{+8}" } }

        [objects.0x2031]
        name    = "Plain"
        kind    = "array"
        type    = "INT32"
        entries = { "1..=2" = { name = "Value" } }

        [tx-pdos.0x1A00]
        name    = "Variables"
        entries = ["VAR10"]
        "#,
    );
    let names = |index| {
        let object = device.object(devc::model::Index(index)).expect("it is described");
        object.entries.iter().skip(1).map(|entry| entry.name.as_str()).collect::<Vec<_>>()
    };
    assert_eq!(names(0x2030), ["VAR9 (1)", "VAR10 (2)", "VAR11 (3)"]);
    assert_eq!(names(0x2031), ["Value 1", "Value 2"]);
    let mapped = device.pdos[0].entries[0].address.map(|address| address.to_string());
    assert_eq!(mapped.as_deref(), Some("0x2030:02"));
}
