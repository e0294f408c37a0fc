//! Nothing outside of a description's folder is read, looked at or talked about.

use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use crate::{Desk, SOUND};

#[test]
fn a_link_out_of_the_folder_is_an_outside_include() {
    let desk = Desk::new(&[("drive", &format!("include = [\"link.toml\"]\n{SOUND}"))]);
    desk.put("elsewhere.toml", "");
    desk.link("../../elsewhere.toml", "devices/drive/link.toml");
    desk.devc(&["check"]).ends(1, &["error[outside-include]"]);
}

/// Whether the name is almost right, right, or nothing like what is there, the answer is the same.
#[test]
fn what_lies_outside_is_not_suggested() {
    let lead = [
        "../../secre.toml",
        "../../secret.toml",
        "../../nothing.toml",
        "/etc/passw",
        "out/secre.toml",
        "out/no/secret",
    ];
    for include in lead {
        let text = format!("include = [\"{include}\"]\n{SOUND}");
        let desk = Desk::new(&[("drive", &text)]);
        desk.put("secret.toml", "secret = 1\n");
        desk.link("../..", "devices/drive/out");
        let run = desk.devc(&["check", "--fix"]);
        run.ends(1, &["error[outside-include]", &format!("`{include}` lies outside the folder")]);
        assert!(!run.err.contains("passwd") && !run.err.contains("did you mean"), "{}", run.err);
        assert_eq!(desk.read("devices/drive/device.toml"), text);
    }
}

#[test]
fn what_lies_inside_is_suggested_and_written_as_it_is() {
    for (wrong, right) in [
        ("part.tml", "part.toml"),
        ("sub/part.tml", "sub/part.toml"),
        ("./sub/../part.tml", "./sub/../part.toml"),
    ] {
        let desk = Desk::new(&[("drive", &format!("include = [\"{wrong}\"]\n{SOUND}"))]);
        desk.put("devices/drive/part.toml", "");
        desk.put("devices/drive/sub/part.toml", "");
        desk.devc(&["check", "--fix"]).ends(0, &["made 1 edit"]);
        assert_eq!(desk.read("devices/drive/device.toml"), format!("include = [\"{right}\"]\n{SOUND}"));
    }
    // no text could name these as they are
    for (wrong, there) in
        [("part.tom", "part\"toml"), ("sub/part.toml/", "sub/part.tom"), ("nowhere/part.toml", "part.toml")]
    {
        let text = format!("include = [\"{wrong}\"]\n{SOUND}");
        let desk = Desk::new(&[("drive", &text)]);
        desk.put(&format!("devices/drive/{there}"), "");
        desk.devc(&["check", "--fix"]).ends(1, &["error[missing-file]"]);
        assert_eq!(desk.read("devices/drive/device.toml"), text);
    }
}

/// Links are turned all the time while devc reads: between its look at the path and the opening too.
#[test]
fn a_link_that_is_turned_while_devc_reads() {
    for (include, turned, targets) in [
        ("part.toml", "devices/drive/part.toml", ["good/part.toml", "../../secret/part.toml"]),
        ("here/part.toml", "devices/drive/here", ["good", "../../secret"]),
    ] {
        let desk = Desk::new(&[("drive", &format!("include = [\"{include}\"]\n{SOUND}"))]);
        desk.put("devices/drive/good/part.toml", "");
        desk.put("secret/part.toml", "password = 1\n");
        desk.link(targets[0], turned);
        let done = AtomicBool::new(false);
        thread::scope(|scope| {
            scope.spawn(|| {
                for target in targets.iter().cycle().take_while(|_| !done.load(Ordering::Relaxed)) {
                    desk.link(target, "turning");
                    fs::rename(desk.path("turning"), desk.path(turned)).expect("a link");
                }
            });
            for _ in 0..60 {
                let run = desk.devc(&["check"]);
                if run.err.contains("password") {
                    done.store(true, Ordering::Relaxed);
                    panic!("read what lies outside: {}", run.err);
                }
            }
            done.store(true, Ordering::Relaxed);
        });
    }
}
