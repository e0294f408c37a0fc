//! What is written, what is not, and what is removed.

use std::fs;

use crate::{Desk, SOUND};

#[test]
fn every_description_under_devices_is_built() {
    let desk = Desk::new(&[("a", SOUND), ("b", SOUND)]);
    desk.put("devices/notes/readme.txt", "not a description");
    let run = desk.devc(&["build"]);
    run.ends(0, &["devices/a: wrote", "devices/b: wrote"]);
    assert_eq!(run.err, "");
    assert_eq!(desk.list("generated"), ["a", "b"]);
    assert!(desk.read("generated/a/a.xml").starts_with("<?xml"));
}

#[test]
fn paths_and_output_folder_are_the_users() {
    let desk = Desk::new(&[("a", SOUND), ("b", SOUND), ("c", SOUND)]);
    desk.devc(&["build", "devices/c", "devices/a/device.toml", "devices/c", "--out", "some/where"])
        .ends(0, &[]);
    assert_eq!(desk.list("some/where"), ["a", "c"]);
    assert!(desk.list("generated").is_empty());
}

#[test]
fn only_what_is_asked_for_is_made() {
    let desk = Desk::sound();
    desk.devc(&["build", "--emit", "xml"]).ends(0, &["wrote drive.xml to generated/drive"]);
    assert_eq!(desk.list("generated/drive"), ["drive.xml"]);
    desk.put("generated/drive/drive.old", "");
    desk.devc(&["build", "--emit", "xml"]).ends(0, &["1 file up to date"]);
    assert_eq!(
        desk.list("generated/drive"),
        ["drive.old", "drive.xml"],
        "other outputs are not its business"
    );
}

#[test]
fn outputs_are_named_one_by_one_or_together() {
    let desk = Desk::sound();
    desk.devc(&["build", "-o", "of-itself"]).ends(0, &[]);
    desk.devc(&["build", "-o", "default", "--emit", "default"]).ends(0, &[]);
    assert_eq!(desk.list("default/drive"), desk.list("of-itself/drive"));
    desk.devc(&["build", "-o", "all", "--emit", "all"]).ends(0, &[]);
    let all = desk.list("all/drive");
    assert!(desk.list("default/drive").iter().all(|name| all.contains(name)), "{all:?}");
    desk.devc(&["build", "--emit", "default,png"]).ends(2, &["png", "json", "default", "all"]);
}

#[test]
fn what_does_not_change_is_not_written() {
    let desk = Desk::sound();
    desk.devc(&["build"]).ends(0, &["wrote"]);
    let path = desk.path("generated/drive/drive.xml");
    let time = || fs::metadata(&path).and_then(|data| data.modified()).expect("a time");
    let before = time();
    desk.devc(&["build"]).ends(0, &["up to date"]);
    assert_eq!(time(), before);
}

#[test]
fn the_same_description_gives_the_same_bytes() {
    let desk = Desk::sound();
    desk.devc(&["build", "--out", "one"]).ends(0, &[]);
    desk.devc(&["build", "--out", "two"]).ends(0, &[]);
    let names = desk.list("one/drive");
    assert_eq!(names, desk.list("two/drive"));
    for name in names {
        assert_eq!(desk.read(&format!("one/drive/{name}")), desk.read(&format!("two/drive/{name}")));
    }
}

#[test]
fn check_compares_and_writes_nothing() {
    let desk = Desk::sound();
    desk.devc(&["build", "--check"]).ends(1, &["`generated/drive/drive.xml` is missing", "not up to date"]);
    assert!(desk.list("generated").is_empty());
    desk.devc(&["build"]).ends(0, &[]);
    desk.devc(&["build", "--check"]).ends(0, &["up to date"]);
    let text = desk.read("generated/drive/drive.xml");
    let edited = text.replacen("Example", "Changed", 1);
    desk.put("generated/drive/drive.xml", &edited);
    desk.devc(&["build", "--check"]).ends(1, &["drive.xml` differs", "from line "]);
    assert_eq!(desk.read("generated/drive/drive.xml"), edited);
}

#[test]
fn timings_name_each_stage() {
    let desk = Desk::sound();
    let run = desk.devc(&["build", "--timings"]);
    run.ends(0, &[]);
    for stage in ["load", "decode", "resolve", "check", "xml", "write", "total"] {
        assert!(run.err.contains(&format!("\n  {stage} ")), "{}", run.err);
    }
    desk.devc(&["build", "--check", "--timings"]).ends(0, &["\n  compare "]);
}

#[test]
fn two_descriptions_cannot_share_a_folder() {
    let desk = Desk::sound();
    desk.put("others/drive/device.toml", SOUND);
    desk.devc(&["build", "devices/drive", "others/drive"])
        .ends(2, &["would both be written to the folder `drive`"]);
}
