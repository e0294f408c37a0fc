//! Outputs that cannot be written: a reason, exit code 2, and everything as it was.

use std::fs;

use crate::Desk;
#[cfg(unix)]
use crate::lock;

#[test]
fn a_file_in_place_of_the_output_folder() {
    let desk = Desk::sound();
    desk.put("generated", "mine");
    desk.devc(&["build"]).ends(2, &["generated", "not a directory"]);
    assert_eq!(desk.read("generated"), "mine");
}

#[test]
fn a_folder_in_place_of_an_output() {
    let desk = Desk::sound();
    desk.put("generated/drive/drive.xml/mine", "");
    desk.devc(&["build"]).ends(2, &["`generated/drive/drive.xml`", "is a directory"]);
    assert_eq!(desk.list("generated/drive"), ["drive.xml"]);
    assert_eq!(desk.list("generated/drive/drive.xml"), ["mine"]);
}

#[test]
#[cfg(unix)]
fn a_folder_that_cannot_be_written_to() {
    let desk = Desk::sound();
    desk.put("generated/drive/drive.xml", "old");
    if lock(&desk.path("generated/drive")) {
        desk.devc(&["build"]).ends(2, &["cannot write `generated/drive/", "permission denied"]);
        assert_eq!(desk.read("generated/drive/drive.xml"), "old");
    }
    let open = std::os::unix::fs::PermissionsExt::from_mode(0o755);
    fs::set_permissions(desk.path("generated/drive"), open).expect("a mode can be set");
}

#[test]
#[cfg(unix)]
fn a_link_out_of_the_output_folder() {
    let desk = Desk::sound();
    fs::create_dir(desk.path("elsewhere")).expect("a folder");
    fs::create_dir(desk.path("generated")).expect("a folder");
    std::os::unix::fs::symlink("../elsewhere", desk.path("generated/drive")).expect("a link");
    desk.devc(&["build"]).ends(2, &["`generated/drive` is a link that leads out of `generated`"]);
    assert!(desk.list("elsewhere").is_empty());
}

/// A disk that is full in the middle of a file, as a limit on the size of files plays it.
#[test]
#[cfg(target_os = "linux")]
fn a_write_that_fails_half_way() {
    let desk = Desk::sound();
    desk.devc(&["build"]).ends(0, &[]);
    let names = desk.list("generated/drive");
    for name in &names {
        desk.put(&format!("generated/drive/{name}"), "old");
    }
    let script = "trap '' XFSZ; ulimit -f 1; exec \"$1\" build";
    let mut shell = std::process::Command::new("sh");
    let run = desk.finish(shell.arg("-c").arg(script).arg("sh").arg(env!("CARGO_BIN_EXE_devc")));
    run.ends(2, &["cannot write `generated/drive/", "file too large"]);
    assert_eq!(desk.list("generated/drive"), names, "nothing is left lying about");
    for name in &names {
        assert_eq!(desk.read(&format!("generated/drive/{name}")), "old", "{name} is as it was");
    }
}

#[test]
#[cfg(unix)]
fn one_description_that_cannot_be_written_does_not_stop_the_others() {
    let desk = Desk::new(&[("a", crate::SOUND), ("b", crate::SOUND)]);
    desk.put("generated/a", "a file");
    desk.devc(&["build"]).ends(2, &["not a directory"]);
    assert!(desk.list("generated/b").contains(&"b.xml".to_owned()));
}
