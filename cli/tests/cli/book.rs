//! The commands in the book, run as they stand there. What needs a network or a program of somebody else is left out.

use std::fs;
use std::path::Path;

use crate::Desk;

/// The commands of devc in a chapter: what is indented and begins with its name.
fn commands(chapter: &str) -> Vec<Vec<String>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/src").join(chapter);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let lines = text.lines().filter_map(|line| line.strip_prefix("    devc "));
    let commands = lines.map(|line| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>());
    commands.filter(|command| command.first().is_some_and(|name| name != "run")).collect()
}

fn run(desk: &Desk, command: &[String]) -> String {
    let arguments: Vec<&str> = command.iter().map(String::as_str).collect();
    desk.devc(&arguments).ends(0, &[]).out.clone()
}

#[test]
fn a_drive_in_ten_minutes() {
    let desk = Desk::new(&[]);
    let commands = commands("ten-minutes.md");
    let said: Vec<String> = commands.iter().map(|command| run(&desk, command)).collect();
    assert!(commands.len() >= 4, "{commands:?}");
    assert!(said.concat().contains("no findings"), "{said:?}");
    for file in ["spindle.xml", "spindle.md", "spindle.json", "spindle.rs", "spindle.html", "spindle.py"] {
        assert!(desk.list("generated/spindle").contains(&file.to_owned()), "{file} is not there");
    }
    // the mistake that the chapter makes, and what is said of it
    let path = "devices/spindle/device.toml";
    desk.put(path, desk.read(path).replace("target-position\"", "target-positon\""));
    desk.devc(&["check"]).ends(1, &["unknown-reference", "target-positon", "there is `target-position`"]);
}

#[test]
fn a_pipeline_from_an_esi() {
    let desk = Desk::new(&[]);
    desk.devc(&["new", "devices/drive"]).ends(0, &[]);
    desk.devc(&["build"]).ends(0, &[]);
    desk.put("vendor.xml", desk.read("generated/drive/drive.xml"));
    for folder in ["devices", "generated"] {
        fs::remove_dir_all(desk.path(folder)).expect("a folder");
    }
    // comparing needs a repository with a history
    let commands = commands("pipeline.md").into_iter().filter(|command| command[0] != "diff");
    let said: Vec<String> = commands.map(|command| run(&desk, &command)).collect();
    assert!(said.len() >= 8, "{said:?}");
    assert!(desk.read("loss.json").contains("\"kept\""));
    assert_eq!(desk.list(".github/workflows"), ["devc.yml"]);
}
