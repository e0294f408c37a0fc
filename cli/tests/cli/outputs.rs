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

/// The files that links of a text lead to, each once.
fn linked(text: &str) -> Vec<&str> {
    let links = text.split("](").skip(1).filter_map(|rest| rest.split(['#', ')']).next());
    let mut files: Vec<&str> = links.filter(|file| !file.is_empty()).collect();
    files.sort_unstable();
    files.dedup();
    files
}

#[test]
fn chapters_are_files_that_lead_to_each_other() {
    let desk = Desk::sound();
    desk.devc(&["build", "--emit", "md", "--chapters"])
        .ends(0, &["wrote drive.md, drive.md.d/", " to generated/drive"]);
    assert_eq!(desk.list("generated/drive"), ["drive.md", "drive.md.d"]);
    let chapters = desk.list("generated/drive/drive.md.d");
    let contents = desk.read("generated/drive/drive.md");
    let expected: Vec<String> = chapters.iter().map(|name| format!("drive.md.d/{name}")).collect();
    assert_eq!(linked(&contents), expected, "the contents lead to each");
    assert!(!contents.contains("0x2000"), "what is in a chapter is not in the contents: {contents}");
    let objects = desk.read("generated/drive/drive.md.d/objects.md");
    assert!(objects.contains("`0x2000`") && objects.contains("Speed"), "{objects}");
    for name in &chapters {
        let text = desk.read(&format!("generated/drive/drive.md.d/{name}"));
        assert!(linked(&text).contains(&"../drive.md"), "{name} leads back");
        for file in linked(&text) {
            assert!(desk.path(&format!("generated/drive/drive.md.d/{file}")).is_file(), "{name}: {file}");
        }
    }
}

#[test]
fn chapters_are_compared_and_kept_as_other_outputs_are() {
    let desk = Desk::sound();
    let (one, many) = (["build", "--emit", "md"], ["build", "--emit", "md", "--chapters"]);
    let check = |arguments: &[&str]| desk.devc(&[arguments, &["--check"]].concat());
    check(&many).ends(1, &["`generated/drive/drive.md.d/objects.md` is missing"]);
    assert!(desk.list("generated").is_empty());
    desk.devc(&many).ends(0, &["wrote"]);
    check(&many).ends(0, &["up to date"]);
    check(&one).ends(1, &["drive.md` differs"]);
    let contents = desk.read("generated/drive/drive.md");
    // the project says the same as the option
    desk.put("devc.toml", "[outputs]\nchapters = true\n");
    check(&one).ends(0, &["up to date"]);
    desk.put("devc.toml", "");
    desk.devc(&one).ends(0, &["wrote drive.md"]);
    assert_ne!(desk.read("generated/drive/drive.md"), contents);
    assert!(!desk.list("generated/drive/drive.md.d").is_empty(), "devc removes nothing");
    desk.put("generated/drive/drive.md.d/objects.md", "my own notes\n");
    desk.devc(&many).ends(2, &["objects.md"]);
    assert_eq!(desk.read("generated/drive/drive.md.d/objects.md"), "my own notes\n");
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
