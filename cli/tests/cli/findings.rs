//! Descriptions with faults.

use crate::{Desk, SOUND};

/// A sound description in which one thing is wrong.
fn misspelled() -> String {
    SOUND.replace("access = ", "acess  = ")
}

/// A sound description with something to look at.
fn doubtful() -> String {
    format!(
        "{SOUND}\n[objects.0x2001]\nname = \"Gains\"\n[objects.0x2001.entries]\n\
         0 = {{ default = 3 }}\n1 = {{ name = \"Gain\", type = \"UINT16\" }}\n"
    )
}

#[test]
fn errors_are_findings_and_keep_the_outputs() {
    let desk = Desk::sound();
    desk.devc(&["build"]).ends(0, &["wrote"]);
    let before = desk.read("generated/drive/drive.xml");
    desk.put("devices/drive/device.toml", misspelled());
    desk.devc(&["check"]).ends(1, &["error[unknown-key]", "device.toml:14:1", "devices/drive: 1 error"]);
    desk.devc(&["build"]).ends(1, &["error[unknown-key]", "devices/drive: nothing made, 1 error"]);
    assert_eq!(desk.read("generated/drive/drive.xml"), before);
}

#[test]
fn one_bad_description_does_not_stop_the_others() {
    let desk = Desk::new(&[("a", SOUND), ("b", &misspelled()), ("c", SOUND)]);
    desk.devc(&["build"]).ends(1, &["devices/b: nothing made"]);
    assert_eq!(desk.list("generated"), ["a", "c"]);
}

#[test]
fn warnings_are_findings_only_on_demand() {
    let desk = Desk::new(&[("drive", &doubtful())]);
    desk.devc(&["check"]).ends(0, &["warning[contradicted-count]", "devices/drive: 1 warning"]);
    desk.devc(&["check", "--deny-warnings"]).ends(1, &["warning[contradicted-count]"]);
    desk.devc(&["build", "--deny-warnings"]).ends(1, &["wrote"]);
    desk.devc(&["build"]).ends(0, &["up to date, 1 warning"]);
}

#[test]
fn messages_and_results_do_not_mix() {
    let desk = Desk::new(&[("a", &misspelled()), ("b", SOUND)]);
    let run = desk.devc(&["check"]);
    assert_eq!(run.out, "devices/a: 1 error\ndevices/b: no findings\n");
    assert!(run.err.starts_with("error[unknown-key]"), "{}", run.err);
}

/// The superuser may read anything; for others a file without permission is reported where it is included.
#[test]
#[cfg(unix)]
fn an_unreadable_file_is_reported() {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;

    let desk = Desk::new(&[("drive", &format!("include = [\"locked.toml\"]\n{SOUND}"))]);
    desk.put("devices/drive/locked.toml", "");
    let locked = desk.path("devices/drive/locked.toml");
    fs::set_permissions(&locked, fs::Permissions::from_mode(0o000)).expect("a mode can be set");
    let expected: (i32, &[&str]) = match fs::read(&locked) {
        Ok(_) => (0, &["no findings"]),
        Err(_) => (1, &["error[unreadable-file]", "permission denied", "included here"]),
    };
    desk.devc(&["check"]).ends(expected.0, expected.1);
}

/// What someone might write to make devc run out of time or memory is refused at once.
#[test]
fn monsters_are_refused() {
    let deep = "a.".repeat(100_000);
    let nested = "[".repeat(100_000);
    for (name, text) in [
        ("dotted", format!("{SOUND}\n[objects.0x2001]\n{deep}a = 1\n")),
        ("nested", format!("{SOUND}\n[objects.0x2001]\ndefault = {nested}\n")),
        ("names", format!("{SOUND}\n[axes]\nnames = [{}]\n", "\"X\", ".repeat(100_000))),
        ("tables", format!("{SOUND}\n{}", "[[errata]]\n".repeat(20_000))),
    ] {
        let desk = Desk::new(&[(name, &text)]);
        let start = std::time::Instant::now();
        let run = desk.devc(&["check"]);
        assert_eq!(run.code, Some(1), "{name}: {}", run.err.chars().take(2000).collect::<String>());
        assert!(run.err.len() < 100_000, "{name} says more than anybody reads");
        assert!(start.elapsed().as_secs() < 20, "{name} took {:?}", start.elapsed());
    }
}

/// What is not there is answered with how it comes to be there.
#[test]
fn a_reference_to_nothing_says_what_to_write() {
    let with = |text: &str| format!("profiles = [\"ethercat\", \"cia402\"]\n{SOUND}{text}\n");
    for (text, answer) in [
        ("unit = \"mA\"", "describe it in `[units.mA]`"),
        ("values = \"gears\"", "describe it in `[enumerations.gears]`"),
        (
            "[tx-pdos.0x1A00]\nname = \"A\"\nentries = [\"velocity actual\"]",
            "a profile has `velocity-actual-value`",
        ),
        ("[tx-pdos.0x1A00]\nname = \"A\"\nentries = [\"velocity-actual-value\"]", "add `[objects.0x606C]`"),
        ("[tx-pdos.0x1A00]\nname = \"A\"\nentries = [\"0x606C\"]", "add `[objects.0x606C]`"),
        ("[modes]\ncsp = {}", "expected the code of a mode of operation"),
        ("[homing-methods]\nindex = {}", "expected"),
        ("[vendor-codes]\nlow = {}", "expected"),
        ("[transitions]\nenable = {}", "expected the number of a transition"),
    ] {
        let desk = Desk::new(&[("drive", &with(text))]);
        let run = desk.devc(&["check"]);
        run.ends(1, &[answer]);
        assert!(!run.err.contains("missing-key"), "{}", run.err);
    }
}
