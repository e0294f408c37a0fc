//! What makes it easy to begin, and to go on.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::{fs, thread};

use crate::{Desk, PATIENCE, SOUND};

/// Every command that `devc help` lists is known to the shells and has a page of the manual.
#[test]
fn shells_and_the_manual_know_all_commands() {
    let desk = Desk::new(&[]);
    let help = desk.devc(&["help"]).out;
    let (_, commands) = help.split_once("Commands:\n").expect("a list");
    let lines = commands.lines().take_while(|line| !line.is_empty());
    // what is said of a command may need another line, which is indented
    let commands: Vec<&str> = lines.filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).collect();
    let commands: Vec<&str> = commands.into_iter().filter(|command| !command.is_empty()).collect();
    assert!(commands.contains(&"fmt") && commands.contains(&"lsp"), "{commands:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = desk.devc(&["completions", shell]);
        script.ends(0, &commands);
        script.ends(0, &["deny-warnings"]);
    }
    let page = desk.devc(&["man"]);
    page.ends(0, &[".TH devc 1"]);
    for command in commands.iter().filter(|command| **command != "help") {
        let name = command.replace('-', "\\-");
        page.ends(0, &[&format!("devc\\-{name}(1)")]);
        desk.devc(&["man", command]).ends(0, &[".TH", &format!("devc\\-{name}")]);
    }
    desk.devc(&["man", "nonsense"]).ends(2, &["there is no command `nonsense`"]);
}

/// The script of bash is one.
#[cfg(unix)]
#[test]
fn bash_reads_its_script() {
    let desk = Desk::new(&[]);
    desk.put("devc.bash", desk.devc(&["completions", "bash"]).out);
    if let Ok(end) = Command::new("bash").arg("-n").arg(desk.path("devc.bash")).status() {
        assert!(end.success());
    }
}

#[test]
fn a_quiet_run_says_only_what_is_wrong() {
    let desk = Desk::sound();
    for arguments in [&["check", "-q"][..], &["build", "--quiet"], &["-q", "fmt"]] {
        let run = desk.devc(arguments);
        assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (Some(0), "", ""), "{arguments:?}");
    }
    assert!(desk.path("generated/drive/drive.xml").exists());
    desk.put("devices/drive/device.toml", SOUND.replace("access", "acess"));
    let run = desk.devc(&["check", "-q"]);
    run.ends(1, &["unknown-key"]);
    assert_eq!(run.out, "");
    // what was asked for is said all the same
    desk.devc(&["rules", "-q"]).ends(0, &["unknown-key"]);
}

#[test]
fn an_included_file_leads_to_its_description() {
    let desk = Desk::new(&[("drive", &format!("include = [\"a/one.toml\"]\n{SOUND}"))]);
    desk.put("devices/drive/a/one.toml", "include = [\"two.toml\"]\n");
    desk.put("devices/drive/a/two.toml", "[units.a]\nquantity = \"length\"\n");
    desk.put("devices/drive/a/three.toml", "[units.b]\n");
    let run = desk.devc(&["check", "devices/drive/a/two.toml", "devices/drive"]);
    run.ends(
        1,
        &[
            "is a part of `devices/drive/device.toml`, which is taken as a whole",
            "missing-key",
            "devices/drive: 1 error",
        ],
    );
    assert_eq!(run.out.lines().count(), 1, "the description is checked once: {}", run.out);
    desk.put("devices/drive/a/two.toml", "");
    desk.devc(&["build", "devices/drive/a/one.toml"]).ends(0, &["wrote", "generated/drive"]);
    // a file that nobody includes is taken by itself
    let run = desk.devc(&["check", "devices/drive/a/three.toml"]);
    assert!(!run.err.contains("is a part of"), "{}", run.err);
}

#[test]
fn a_repository_is_prepared_and_nothing_in_it_replaced() {
    let desk = Desk::new(&[]);
    desk.put(".gitignore", "target\n");
    let run = desk.devc(&["init"]);
    run.ends(
        0,
        &[".github/workflows/devc.yml: written", ".gitignore: is there, and stays as it is", ".devc-draft-*"],
    );
    assert_eq!(desk.read(".gitignore"), "target\n");
    assert_eq!(desk.read("device.schema.json"), desk.devc(&["schema"]).out);
    assert!(desk.read(".github/workflows/devc.yml").contains("devc check --format github"));
    desk.put(
        ".gitignore",
        "target\n# what a run of devc leaves that was killed; the next one removes it\n.devc-draft-*\n",
    );
    let again = desk.devc(&["init"]);
    again.ends(0, &[]);
    assert!(!again.out.contains("is there, and stays") && !again.out.contains("written"), "{}", again.out);
    desk.devc(&["init", "nowhere"]).ends(2, &["is not a folder"]);
}

/// What the workflow runs are commands that there are, and a new description passes them.
#[test]
fn a_new_description_passes_the_workflow() {
    let desk = Desk::new(&[]);
    desk.devc(&["init"]).ends(0, &[]);
    desk.devc(&["new", "devices/one"]).ends(0, &[]);
    desk.devc(&["new", "devices/two", "--axes", "2", "--mode", "csp,hm"]).ends(0, &[]);
    desk.devc(&["build"]).ends(0, &[]);
    let workflow = desk.read(".github/workflows/devc.yml");
    let commands: Vec<&str> =
        workflow.lines().filter_map(|line| line.split_once("run: devc ")).map(|(_, it)| it).collect();
    assert_eq!(commands.len(), 3);
    for command in commands {
        desk.devc(&command.split(' ').collect::<Vec<_>>()).ends(0, &[]);
    }
}

#[test]
fn a_change_of_any_file_is_built_at_once() {
    let desk = Desk::new(&[("drive", &format!("include = [\"more.toml\"]\n{SOUND}"))]);
    desk.put(
        "devices/drive/more.toml",
        "[objects.0x2001]\nname = \"First\"\ntype = \"UINT8\"\naccess = \"ro\"\n",
    );
    let mut command = desk.command(&["build", "--watch", "--emit", "json"]);
    let mut watch = command.stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("devc runs");
    let (tell, lines) = channel();
    let output = BufReader::new(watch.stdout.take().expect("an output"));
    thread::spawn(move || output.lines().map_while(Result::ok).all(|line| tell.send(line).is_ok()));
    let said = |what: &str| loop {
        let line = lines.recv_timeout(PATIENCE).unwrap_or_else(|_| panic!("it does not say `{what}`"));
        if line.contains(what) {
            break;
        }
    };
    said("watching");
    assert!(desk.read("generated/drive/drive.json").contains("First"));
    desk.put(
        "devices/drive/more.toml",
        "[objects.0x2001]\nname = \"Second\"\ntype = \"UINT8\"\naccess = \"ro\"\n",
    );
    said("wrote drive.json");
    assert!(desk.read("generated/drive/drive.json").contains("Second"));
    // a file that goes, and comes again
    fs::remove_file(desk.path("devices/drive/more.toml")).expect("a file");
    said("nothing made");
    desk.put(
        "devices/drive/more.toml",
        "[objects.0x2001]\nname = \"Third one\"\ntype = \"UINT8\"\naccess = \"ro\"\n",
    );
    said("wrote drive.json");
    watch.kill().expect("it can be stopped");
    watch.wait().expect("it ends");
}
