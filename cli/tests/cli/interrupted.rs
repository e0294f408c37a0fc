//! Runs that do not come to their end, and what they leave behind.

use std::io::pipe;
use std::process::{Child, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::unix::skipped;
use crate::{Desk, SOUND};

/// How many times a run is killed, each time a little later.
const KILLS: u32 = 40;

/// Kills the run of each round, earlier or later, from its start to past its end.
fn kill(round: u32, whole: Duration, mut child: Child) {
    sleep(whole * round / (KILLS - 10));
    child.kill().expect("a signal");
    child.wait().expect("an end");
}

fn duration(run: impl FnOnce()) -> Duration {
    let start = Instant::now();
    run();
    start.elapsed()
}

#[test]
fn a_killed_build_leaves_whole_files() {
    let texts = [SOUND.to_owned(), SOUND.replace("Speed", "Velocity")];
    let desk = Desk::sound();
    for (text, out) in texts.iter().zip(["0", "1"]) {
        desk.put("devices/drive/device.toml", text);
        desk.devc(&["build", "-o", out]).ends(0, &[]);
    }
    let names = desk.list("0/drive");
    let made =
        |out: &str| names.iter().map(|name| desk.read(&format!("{out}/drive/{name}"))).collect::<Vec<_>>();
    let whole = [made("0"), made("1")];
    let time = duration(|| _ = desk.devc(&["build"]).ends(0, &[]));
    for (round, text) in (0..KILLS).zip(texts.iter().cycle()) {
        desk.put("devices/drive/device.toml", text);
        let build =
            desk.command(&["build"]).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("devc");
        kill(round, time, build);
        for (number, text) in made("generated").iter().enumerate() {
            assert!(whole.iter().any(|whole| whole[number] == *text), "{} is torn", names[number]);
        }
    }
    desk.devc(&["build"]).ends(0, &[]);
    assert_eq!(made("generated"), whole[1]);
    assert_eq!(desk.list("generated"), ["drive"], "no draft is left");
    assert_eq!(desk.list("generated/drive"), names);
}

#[test]
fn a_killed_fix_leaves_a_whole_description() {
    let wrong = SOUND.replace("access = ", "acess  = ");
    let right = wrong.replace("acess", "access");
    let desk = Desk::new(&[("drive", &wrong)]);
    let time = duration(|| _ = desk.devc(&["check", "--fix"]).ends(0, &["made 1 edit"]));
    for round in 0..KILLS {
        desk.put("devices/drive/device.toml", &wrong);
        let fix = desk
            .command(&["check", "--fix"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("devc");
        kill(round, time, fix);
        let text = desk.read("devices/drive/device.toml");
        assert!([&wrong, &right].contains(&&text), "{text}");
    }
    desk.put("devices/drive/device.toml", &wrong);
    desk.devc(&["check", "--fix"]).ends(0, &["made 1 edit"]);
    assert_eq!(desk.list("devices/drive"), ["device.toml"], "no draft is left");
}

/// What a run that was killed in the middle of its drafts leaves.
#[test]
fn drafts_of_a_killed_run_go() {
    let desk = Desk::sound();
    desk.put("generated/.devc-draft-1-0", "half");
    desk.put("generated/.devc-draft-1-1", "");
    let others = [".devc-draft-1", ".devc-draft-1-0.txt", ".devc-draft-notes-1"];
    others.iter().for_each(|name| desk.put(&format!("generated/{name}"), "mine"));
    desk.devc(&["build", "--check"]).ends(1, &["missing"]);
    assert_eq!(desk.list("generated").len(), 5, "a run that writes nothing removes nothing");
    desk.devc(&["build"]).ends(0, &[]);
    assert_eq!(desk.list("generated"), [&others[..], &["drive"]].concat());
}

/// A disk that is full in the middle of a file, as a limit on the size of files plays it.
#[test]
#[cfg(target_os = "linux")]
fn a_write_that_fails_half_way() {
    let desk = Desk::sound();
    desk.devc(&["build"]).ends(0, &[]);
    let names = desk.list("generated/drive");
    let before: Vec<String> =
        names.iter().map(|name| desk.read(&format!("generated/drive/{name}"))).collect();
    desk.put("devices/drive/device.toml", SOUND.replace("Speed", "Velocity"));
    desk.shell("trap '' XFSZ; ulimit -f 1; exec \"$1\" build")
        .ends(2, &["cannot write `generated/drive/", "file too large"]);
    assert_eq!(desk.list("generated"), ["drive"], "nothing is left lying about");
    assert_eq!(desk.list("generated/drive"), names);
    let after: Vec<String> = names.iter().map(|name| desk.read(&format!("generated/drive/{name}"))).collect();
    assert_eq!(after, before);
}

/// A disk of its own, which only the script sees.
#[test]
#[cfg(target_os = "linux")]
fn a_full_disk() {
    const SCRIPT: &str = r#"
        mkdir disk; mount -t tmpfs -o size=128k none disk 2>/dev/null || { echo no disk; exit; }
        "$1" build -o disk || exit 3
        mkdir before && cp disk/drive/* before
        sed -i s/Speed/Velocity/ devices/drive/device.toml
        head -c 1M /dev/zero > disk/filler 2>/dev/null
        "$1" build -o disk; echo "code $?"
        diff -r before disk/drive && echo same; ls -A disk
        rm disk/filler; "$1" build -o disk && "$1" build -o disk --check && echo well
    "#;
    let desk = Desk::sound();
    desk.put("script", SCRIPT);
    let run = desk.shell("command -v unshare >/dev/null && exec unshare -rm sh script \"$1\"");
    if run.code != Some(0) && run.out.is_empty() || run.out.contains("no disk") {
        return skipped("no disk can be mounted here");
    }
    run.ends(0, &["no space left on device", "\ncode 2\nsame\ndrive\nfiller\n", "\nwell\n"]);
}

/// Whoever reads the results may go: the work goes on, without complaint.
#[test]
fn a_reader_that_goes() {
    let desk = Desk::new(&[("a", SOUND), ("b", SOUND), ("c", SOUND)]);
    let without_reader = |arguments: &[&str]| {
        let (reader, writer) = pipe().expect("a pipe");
        drop(reader);
        let output = desk.command(arguments).stdout(writer).output().expect("devc");
        (output.status.code(), String::from_utf8(output.stderr).expect("text"))
    };
    assert_eq!(without_reader(&["build"]), (Some(0), String::new()));
    assert_eq!(desk.list("generated"), ["a", "b", "c"]);
    desk.devc(&["build", "--check"]).ends(0, &["devices/c: 4 files up to date"]);
    for arguments in [
        &["check"][..],
        &["check", "--format", "json"],
        &["diff", "devices/a", "devices/a"],
        &["rules"],
        &["explain", "unknown-key"],
        &["--help"],
    ] {
        assert_eq!(without_reader(arguments), (Some(0), String::new()), "{arguments:?}");
    }
    desk.put("generated/a/a.md", "mine");
    desk.put("devices/b/device.toml", SOUND.replace("Speed", "Velocity"));
    assert_eq!(without_reader(&["build"]).0, Some(2), "an error stays one");
    assert!(desk.read("generated/b/b.md").contains("Velocity"));
}

/// Nor does a full disk under the results stop it, but that is said.
#[test]
#[cfg(target_os = "linux")]
fn results_that_cannot_be_written() {
    let desk = Desk::new(&[("a", SOUND), ("b", SOUND)]);
    let run = desk.shell("\"$1\" build > /dev/full");
    run.ends(2, &["cannot write to the standard output: no space left"]);
    assert_eq!(run.err.lines().count(), 1, "{}", run.err);
    assert_eq!(desk.list("generated"), ["a", "b"]);
    assert_eq!(desk.shell("exec \"$1\" build 2>/dev/full >/dev/full").code, Some(2));
    assert_eq!(desk.shell("exec \"$1\" build 2>&- >&- <&-").code, Some(0));
}
