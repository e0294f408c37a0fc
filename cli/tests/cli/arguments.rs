//! What can be asked, and the answers to what cannot.

use crate::{Desk, SOUND};

#[test]
fn help_and_version_are_no_error() {
    let desk = Desk::sound();
    desk.devc(&["--help"]).ends(0, &["Usage: devc", "Examples:", "Exit codes:"]);
    desk.devc(&["build", "--help"]).ends(0, &["--emit <LIST>", "--check", "--timings", "ESI"]);
    desk.devc(&["--version"]).ends(0, &[env!("CARGO_PKG_VERSION")]);
}

#[test]
fn bad_usage_is_not_run() {
    let desk = Desk::sound();
    desk.devc(&[]).ends(2, &["Usage: devc"]);
    desk.devc(&["biuld"]).ends(2, &["biuld", "'build'"]);
    desk.devc(&["build", "--emit", "xlm"]).ends(2, &["xlm", "possible values: xml"]);
    assert!(desk.list("generated").is_empty());
}

#[test]
fn a_path_that_leads_nowhere_is_not_run() {
    let desk = Desk::sound();
    desk.devc(&["check", "devices/drvie"])
        .ends(2, &["`devices/drvie` does not exist", "`drive` lies beside it"]);
    desk.put("empty/readme.txt", "");
    desk.devc(&["check", "empty"]).ends(2, &["`empty` holds no description"]);
}

#[test]
fn without_devices_a_path_is_needed() {
    let desk = Desk::new(&[]);
    desk.devc(&["build"]).ends(2, &["cannot look into `devices`", "name the folder of a description"]);
    desk.put("devices/readme.txt", "");
    desk.devc(&["build"]).ends(2, &["no folder in `devices` holds a `device.toml`"]);
}

#[test]
fn without_a_path_the_description_in_this_folder_is_taken() {
    let desk = Desk::new(&[("drive", SOUND), ("other", SOUND)]);
    desk.devc_in("devices/drive", &["check"]).ends(0, &[".: no findings"]);
    desk.devc_in("devices/drive", &["build"]).ends(0, &["to generated/drive"]);
}

#[test]
fn a_folder_of_descriptions_is_all_of_them() {
    let desk = Desk::new(&[("drive", SOUND), ("other", SOUND)]);
    let run = desk.devc(&["check", "devices", "devices/drive"]);
    run.ends(0, &["devices/drive: no findings", "devices/other: no findings"]);
    assert_eq!(run.out.lines().count(), 2, "{}", run.out);
}

#[test]
fn colours_only_where_they_are_seen() {
    let desk = Desk::new(&[("drive", &SOUND.replace("name   = \"Speed\"", "nmae = \"Speed\""))]);
    assert!(!desk.devc(&["check"]).err.contains('\u{1b}'), "a pipe is no terminal");
    assert!(desk.devc(&["check", "--color", "always"]).err.contains('\u{1b}'));
    assert!(!desk.devc(&["--color=never", "check"]).err.contains('\u{1b}'));
}

/// A reader that goes away early, as `head` does, is no reason to complain; a full disk is.
#[test]
#[cfg(target_os = "linux")]
fn an_output_that_cannot_be_written_to_is_no_panic() {
    let desk = Desk::sound();
    desk.shell("\"$1\" rules > /dev/full").ends(2, &["cannot write to the standard output: no space left"]);
    assert_eq!(desk.shell("\"$1\" rules | true").err, "");
}
