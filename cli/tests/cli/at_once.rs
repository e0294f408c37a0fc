//! Several runs on one folder.

use std::fs::{self, File};
use std::io::{BufRead, BufReader, Read};
use std::process::Stdio;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use crate::{Desk, Run, SOUND};

#[test]
fn all_runs_at_once_succeed() {
    let descriptions: Vec<String> = ["a", "b", "c"].map(str::to_owned).to_vec();
    for round in 0..12 {
        let sound = SOUND.replace("Speed", &format!("Speed {round}"));
        let described: Vec<(&str, &str)> = descriptions.iter().map(|name| (name.as_str(), &*sound)).collect();
        let desk = Desk::new(&described);
        desk.devc(&["build", "-o", "alone"]).ends(0, &[]);
        let start =
            |_| desk.command(&["build"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("devc");
        let runs: Vec<_> = (0..5).map(start).collect();
        runs.into_iter().for_each(|run| _ = Run::of(run).ends(0, &["devices/c: "]));
        assert_eq!(desk.list("generated"), ["a", "b", "c"]);
        for name in &descriptions {
            let outputs = desk.list(&format!("generated/{name}"));
            assert_eq!(outputs, desk.list(&format!("alone/{name}")));
            for output in outputs {
                let read = |out: &str| desk.read(&format!("{out}/{name}/{output}"));
                assert_eq!(read("generated"), read("alone"), "{output}");
            }
        }
    }
}

/// A run that has to wait makes what the description says when its turn comes.
#[test]
fn the_last_run_has_the_last_word() {
    let desk = Desk::sound();
    desk.put("generated/mine", "");
    let folder = File::open(desk.path("generated")).expect("a folder");
    folder.lock().expect("a lock");
    let mut child =
        desk.command(&["build"]).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("devc");
    let mut said = BufReader::new(child.stderr.take().expect("a pipe"));
    let mut line = String::new();
    said.read_line(&mut line).expect("a line");
    assert_eq!(line, "waiting for another devc that writes to `generated`\n");
    desk.put("devices/drive/device.toml", SOUND.replace("Speed", "Velocity"));
    drop(folder);
    said.read_to_string(&mut line).expect("the rest");
    assert!(child.wait().expect("an end").success(), "{line}");
    assert!(desk.read("generated/drive/drive.md").contains("Velocity"));
    desk.devc(&["build", "--check"]).ends(0, &["up to date"]);
}

#[test]
fn only_a_run_that_writes_waits() {
    let desk = Desk::sound();
    desk.devc(&["build"]).ends(0, &[]);
    let folders =
        ["generated", "devices/drive"].map(|folder| File::open(desk.path(folder)).expect("a folder"));
    folders.iter().for_each(|folder| folder.lock().expect("a lock"));
    desk.devc(&["build", "--check"]).ends(0, &["up to date"]);
    desk.devc(&["check", "--fix"]).ends(0, &["no findings"]);
    desk.devc(&["build", "-o", "elsewhere"]).ends(0, &["wrote"]);
}

/// Editors put a new file in the place of the old one; devc reads the one or the other.
#[test]
fn a_description_that_is_saved_all_the_time() {
    let desk = Desk::sound();
    let done = AtomicBool::new(false);
    thread::scope(|scope| {
        scope.spawn(|| {
            while !done.load(Ordering::Relaxed) {
                desk.put("saved", SOUND);
                fs::rename(desk.path("saved"), desk.path("devices/drive/device.toml")).expect("a name");
                thread::sleep(Duration::from_micros(100));
            }
        });
        let runs: Vec<_> = (0..60).map(|_| desk.devc(&["check"])).collect();
        done.store(true, Ordering::Relaxed);
        runs.iter().for_each(|run| _ = run.ends(0, &["no findings"]));
    });
}
