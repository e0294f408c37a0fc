//! Files that are none, and files without end.

use std::fs::File;

use crate::{Desk, Run, SOUND};

/// A file far larger than memory; it takes no room on the disk.
fn endless(desk: &Desk, path: &str, head: &str) {
    desk.put(path, head);
    let file = File::options().append(true).open(desk.path(path)).expect("a file");
    file.set_len(1 << 40).expect("a file with a hole");
}

#[test]
fn a_pipe_is_not_waited_for() {
    let desk = Desk::new(&[("drive", &format!("include = [\"part.toml\"]\n{SOUND}"))]);
    desk.pipe("devices/drive/part.toml");
    desk.devc(&["check"])
        .ends(1, &["error[unreadable-file]", "`devices/drive/part.toml`", "it is no plain file"]);

    let desk = Desk::sound();
    desk.put("devices/other/readme.txt", "");
    desk.pipe("devices/other/device.toml");
    desk.devc(&["build"])
        .ends(2, &["`devices/other/device.toml`", "it is no plain file", "devices/drive: wrote"]);

    let desk = Desk::sound();
    desk.put("generated/drive/mine", "");
    desk.pipe("generated/drive/drive.md");
    let words = ["`generated/drive/drive.md` is a pipe or a device, not a plain file"];
    desk.devc(&["build"]).ends(2, &words);
    desk.devc(&["build", "--check"]).ends(2, &words);
    assert_eq!(desk.list("generated/drive"), ["drive.md", "mine"]);

    desk.pipe("known.json");
    for arguments in [
        &["check", "--baseline", "known.json"][..],
        &["check", "--baseline", "known.json", "--update-baseline"],
    ] {
        desk.devc(arguments).ends(2, &["`known.json` is a pipe or a device, not a plain file"]);
    }
}

#[test]
fn a_pipe_in_a_repository_stays() {
    let desk = Desk::sound();
    desk.pipe(".gitignore");
    desk.devc(&["init"]).ends(0, &[".gitignore: is there, and stays as it is"]);
}

/// A description may be a link: to a device it leads to no end.
#[test]
fn a_device_is_not_read() {
    let desk = Desk::sound();
    for device in ["/dev/zero", "/dev/tty", "/dev/stdin"] {
        desk.put("devices/other/readme.txt", "");
        desk.link(device, "devices/other/device.toml");
        assert_eq!(desk.devc(&["check", "devices/other"]).code, Some(2), "{device}");
        std::fs::remove_file(desk.path("devices/other/device.toml")).expect("a link");
    }
    desk.devc(&["check", "--baseline", "/dev/zero"]).ends(2, &["`/dev/zero` is a pipe or a device"]);
    desk.devc(&["build", "-o", "/dev/null"]).ends(2, &["`/dev/null` is not a folder"]);
}

/// The least that the system must give is room for devc and one file.
fn frugal(desk: &Desk, arguments: &str) -> Run {
    desk.shell(&format!("ulimit -v 2000000; exec \"$1\" {arguments}"))
}

#[test]
fn a_file_without_end_is_not_read_to_its_end() {
    let desk = Desk::new(&[("drive", &format!("include = [\"part.toml\"]\n{SOUND}"))]);
    endless(&desk, "devices/drive/part.toml", "");
    frugal(&desk, "check").ends(1, &["`devices/drive/part.toml` is larger than 64 MiB"]);

    let desk = Desk::sound();
    endless(&desk, "known.json", "{}");
    frugal(&desk, "check --baseline known.json").ends(2, &["it is larger than 64 MiB"]);
    endless(&desk, "generated/drive/drive.md", "mine\n");
    frugal(&desk, "build").ends(2, &["drive.md` was not made by devc"]);
    endless(&desk, "generated/drive/drive.md", "<!-- Made by devc from the description of drive -->\n");
    frugal(&desk, "build").ends(0, &["drive.md"]);
}
