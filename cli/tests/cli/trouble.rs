//! Outputs that cannot be written: a reason, exit code 2, and everything as it was.

use crate::{Desk, SOUND};

#[test]
fn a_file_in_place_of_the_output_folder() {
    let desk = Desk::sound();
    desk.put("generated", "mine");
    desk.devc(&["build"]).ends(2, &["`generated` is not a folder", "--out"]);
    assert_eq!(desk.read("generated"), "mine");
}

#[test]
fn a_folder_in_place_of_an_output() {
    let desk = Desk::sound();
    desk.put("generated/drive/drive.xml/mine", "");
    desk.devc(&["build"]).ends(2, &["`generated/drive/drive.xml` is a folder"]);
    assert_eq!(desk.list("generated/drive"), ["drive.xml"]);
    assert_eq!(desk.list("generated/drive/drive.xml"), ["mine"]);
}

#[test]
fn one_description_that_cannot_be_written_does_not_stop_the_others() {
    let desk = Desk::new(&[("a", SOUND), ("b", SOUND)]);
    desk.put("generated/a", "a file");
    desk.devc(&["build"]).ends(2, &["generated/a", "devices/b: wrote"]);
    assert!(desk.list("generated/b").contains(&"b.xml".to_owned()));
    assert_eq!(desk.read("generated/a"), "a file");
}

/// After "Naming Files, Paths, and Namespaces" of the Windows documentation: outputs are checked in, and out elsewhere.
#[test]
fn a_folder_whose_name_not_every_system_takes() {
    let mut names = vec!["aux", "Com1.drive", "lpt9"];
    if cfg!(unix) {
        names.extend(["a:b", "a\\b", "a?", "a|b", "drive.", "drive "]);
    }
    for name in names {
        let desk = Desk::new(&[(name, SOUND), ("sound", SOUND)]);
        let run = desk.devc(&["build"]);
        run.ends(2, &["cannot be the name of an output", "rename the folder", "devices/sound: wrote"]);
        assert_eq!(desk.list("generated"), ["sound"], "{name:?}");
    }
}

/// That is a fault of the description, found before any output is made.
#[test]
#[cfg(unix)]
fn a_folder_whose_name_no_text_may_hold() {
    for name in ["a\nb", "\u{1b}[31m"] {
        let desk = Desk::new(&[(name, SOUND), ("sound", SOUND)]);
        let run = desk.devc(&["build"]);
        run.ends(1, &["error[forbidden-character]", "rename the folder", "devices/sound: wrote"]);
        assert_eq!(desk.list("generated"), ["sound"], "{name:?}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_folder_whose_name_is_no_text() {
    use std::os::unix::ffi::OsStrExt;

    let desk = Desk::sound();
    let name = std::ffi::OsStr::from_bytes(b"drive\xFF");
    std::fs::rename(desk.path("devices/drive"), desk.path("devices").join(name)).expect("a name");
    desk.devc(&["build"]).ends(2, &["it is not UTF-8", "rename the folder"]);
    assert!(desk.list("generated").is_empty());
}

/// Names of 255 bytes are what most file systems take.
#[test]
fn the_longest_names() {
    let (longest, too_long) = ("a".repeat(250), "a".repeat(251));
    Desk::new(&[(&longest, SOUND)]).devc(&["build"]).ends(0, &["wrote"]);
    let desk = Desk::new(&[(&too_long, SOUND)]);
    desk.devc(&["build"]).ends(2, &["more than 255 bytes"]);
    assert!(desk.list("generated").is_empty());
}

#[test]
fn names_that_are_one_on_some_systems() {
    let desk = Desk::sound();
    desk.put("others/DRIVE/device.toml", SOUND);
    desk.devc(&["build", "devices/drive", "others/DRIVE"])
        .ends(2, &["would both be written to the folder", "devices/drive: wrote"]);
    assert_eq!(desk.list("generated"), ["drive"]);
}

#[test]
#[cfg(unix)]
fn a_folder_that_cannot_be_written_to() {
    use std::fs::{Permissions, set_permissions};
    use std::os::unix::fs::PermissionsExt;

    let desk = Desk::sound();
    desk.devc(&["build"]).ends(0, &[]);
    desk.put("devices/drive/device.toml", SOUND.replace("Speed", "Velocity"));
    let before = desk.read("generated/drive/drive.xml");
    for folder in ["generated", "generated/drive"] {
        set_permissions(desk.path(folder), Permissions::from_mode(0o555)).expect("a mode");
        match desk.as_nobody(&["build"]) {
            Some(run) => _ = run.ends(2, &["cannot write `generated/drive/", "permission denied"]),
            None => crate::unix::skipped("the superuser may write anywhere"),
        }
        assert_eq!(desk.list("generated"), ["drive"]);
        assert_eq!(desk.read("generated/drive/drive.xml"), before);
        set_permissions(desk.path(folder), Permissions::from_mode(0o755)).expect("a mode");
    }
}
