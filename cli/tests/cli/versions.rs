//! `devc new`, `devc diff` and `devc schema`.

use std::process::Command;

use crate::{Desk, SOUND};

/// Runs git in the desk, without the settings of whoever runs the tests.
fn git(desk: &Desk, arguments: &[&str]) {
    let run = Command::new("git")
        .current_dir(desk.path(""))
        .env("GIT_CONFIG_GLOBAL", "/dev/null")
        .env("GIT_CONFIG_SYSTEM", "/dev/null")
        .args(["-c", "user.name=A", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main"])
        .args(arguments)
        .output();
    let run = run.expect("git runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
}

#[test]
fn what_is_begun_is_whole() {
    for axes in ["1", "2", "8"] {
        for mode in ["pp", "pv", "tq", "hm", "csp", "csv", "cst", "csp,hm", "cst,csv,csp,hm,tq,pv,pp"] {
            let desk = Desk::new(&[]);
            let made = desk.devc(&["new", "devices/my-drive", "--axes", axes, "--mode", mode]);
            assert_eq!(made.code, Some(0), "{}", made.err);
            let checked = desk.devc(&["check", "--deny-warnings", "devices/my-drive"]);
            assert_eq!(checked.code, Some(0), "{axes} axes, {mode}: {}{}", checked.out, checked.err);
        }
    }
}

#[test]
fn nothing_is_begun_over_what_is_there() {
    let desk = Desk::sound();
    let run = desk.devc(&["new", "devices/drive"]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("is there already"), "{}", run.err);
    assert_eq!(desk.read("devices/drive/device.toml"), SOUND);
    let run = desk.devc(&["new", "devices/a drive\""]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("cannot be the name"), "{}", run.err);
}

#[test]
fn two_folders_are_compared() {
    let desk = Desk::new(&[("old", SOUND), ("new", &SOUND.replace("UINT16", "INT16"))]);
    let run = desk.devc(&["diff", "devices/old", "devices/new"]);
    assert_eq!(run.code, Some(1), "{}", run.err);
    assert!(run.out.contains("wire-breaking: 1"), "{}", run.out);
    assert!(run.out.contains("changed-type 0x2000:00 Speed: UINT16 → INT16"), "{}", run.out);
    assert!(run.out.contains("devices/old/device.toml:13:10 → devices/new/device.toml:13:10"), "{}", run.out);
    let same = desk.devc(&["diff", "devices/old", "devices/old"]);
    assert_eq!((same.code, &*same.out), (Some(0), "nothing changes\n"));
}

#[test]
fn what_is_denied_can_be_chosen() {
    let desk = Desk::new(&[("old", SOUND), ("new", &SOUND.replace("\"Speed\"", "\"Velocity\""))]);
    assert_eq!(desk.devc(&["diff", "devices/old", "devices/new"]).code, Some(0));
    let run = desk.devc(&["diff", "devices/old", "devices/new", "--deny", "documentation"]);
    assert_eq!(run.code, Some(1), "{}", run.err);
}

#[test]
fn the_gate_asks_for_a_revision() {
    let changed = SOUND.replace("UINT16", "INT16");
    let raised = changed.replace("revision     = 1", "revision     = 2");
    let desk = Desk::new(&[("old", SOUND), ("new", &changed), ("raised", &raised)]);
    let run = desk.devc(&["diff", "devices/old", "devices/new", "--gate"]);
    assert_eq!(run.code, Some(1));
    assert!(run.err.contains("its revision number is still 0x00000001"), "{}", run.err);
    assert_eq!(desk.devc(&["diff", "devices/old", "devices/raised", "--gate"]).code, Some(0));
    let run = desk.devc(&["diff", "devices/raised", "devices/old", "--gate"]);
    assert_eq!(run.code, Some(1));
    assert!(run.err.contains("falls from 0x00000002 to 0x00000001"), "{}", run.err);
}

#[test]
fn revisions_of_git_are_compared() {
    let desk = Desk::sound();
    git(&desk, &["init", "-q"]);
    git(&desk, &["add", "."]);
    git(&desk, &["commit", "-qm", "one"]);
    desk.put("devices/drive/device.toml", SOUND.replace("UINT16", "INT16"));
    let run = desk.devc(&["diff", "main..", "devices/drive"]);
    assert_eq!(run.code, Some(1), "{}", run.err);
    assert!(
        run.out.contains("main:devices/drive/device.toml:13:10 → devices/drive/device.toml:13:10"),
        "{}",
        run.out
    );
    assert_eq!(desk.devc(&["diff", "main..HEAD", "devices/drive/device.toml"]).code, Some(0));
    let run = desk.devc(&["diff", "--", "--exec=x..HEAD", "devices/drive"]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("git knows no revision `--exec=x`"), "{}", run.err);
}

/// What `devc build` makes of a description says the same, as far as an ESI file can.
#[test]
fn an_esi_file_is_a_version() {
    let changed = SOUND.replace("UINT16", "INT16");
    let desk = Desk::new(&[("old", SOUND), ("new", &changed)]);
    desk.devc(&["build", "devices/old", "-o", "out"]).ends(0, &[]);
    let run = desk.devc(&["diff", "out/old/old.xml", "devices/new"]);
    assert_eq!(run.code, Some(1), "{}", run.err);
    assert!(run.out.contains("changed-type 0x2000:00 Speed: UINT16 → INT16"), "{}", run.out);
    let same = desk.devc(&["diff", "out/old/old.xml", "devices/old", "--show", "configuration-breaking"]);
    assert!(!same.out.contains("changed-type"), "{}", same.out);
}

#[test]
fn a_version_with_errors_is_not_compared() {
    let desk = Desk::new(&[("old", SOUND), ("new", &SOUND.replace("UINT16", "UINT15"))]);
    let run = desk.devc(&["diff", "devices/old", "devices/new"]);
    assert_eq!((run.code, &*run.out), (Some(2), ""));
    assert!(run.err.contains("UINT15") && run.err.contains("without errors"), "{}", run.err);
}

#[test]
fn a_comparison_can_be_read_by_programs() {
    let desk = Desk::new(&[("old", SOUND), ("new", &SOUND.replace("UINT16", "INT16"))]);
    let run = desk.devc(&["diff", "devices/old", "devices/new", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&run.out).expect("JSON");
    assert_eq!(json["worst"], "wire-breaking");
    assert_eq!(json["changes"][0]["kind"], "changed-type");
    assert_eq!(json["changes"][0]["old_place"], "devices/old/device.toml:13:10");
    let run = desk.devc(&["diff", "devices/old", "devices/new", "--format", "markdown"]);
    assert!(
        run.out
            .contains("- `0x2000:00` Speed, a value of the same width has another type: UINT16 to INT16\n"),
        "{}",
        run.out
    );
}

/// Changes are shown as the findings of a check are: beside the lines of the new version, at its device if something is
/// gone; what breaks nothing is a remark.
#[test]
fn changes_are_shown_where_findings_are() {
    let more = format!("{SOUND}\n[objects.0x2001]\nname = \"Torque\"\ntype = \"INT16\"\n");
    let changed = SOUND.replace("UINT16", "INT16").replace("\"Speed\"", "\"Velocity\"");
    let desk = Desk::new(&[("old", &more), ("new", &changed)]);
    let run = desk.devc(&["diff", "devices/old", "devices/new", "--format", "github"]);
    assert_eq!(run.code, Some(1), "{}", run.err);
    let place = "file=devices/new/device.toml,line=13,endLine=13";
    assert!(run.out.contains(&format!("::error {place}")), "{}", run.out);
    assert!(run.out.contains("title=changed-type::0x2000:00 Velocity: a value"), "{}", run.out);
    assert!(run.out.contains("::notice file=devices/new/device.toml,line=12"), "{}", run.out);
    assert!(run.out.contains("title=removed-object::0x2001: an object is gone: Torque"), "{}", run.out);
    assert!(run.out.contains("it was at devices/old/device.toml:16:10"), "{}", run.out);
    let run =
        desk.devc(&["diff", "devices/old", "devices/new", "--format", "sarif", "--deny", "wire-breaking"]);
    let log: serde_json::Value = serde_json::from_str(&run.out).expect("JSON");
    let results = log["runs"][0]["results"].as_array().expect("a list");
    let of = |rule: &str| results.iter().find(|result| result["ruleId"] == rule).expect("a result");
    assert_eq!((&of("changed-type")["level"], &of("renamed")["level"]), (&"error".into(), &"note".into()));
    let rules = log["runs"][0]["tool"]["driver"]["rules"].as_array().expect("a list");
    let known =
        |result: &serde_json::Value| &rules[result["ruleIndex"].as_u64().expect("a number") as usize]["id"];
    assert!(results.iter().all(|result| *known(result) == result["ruleId"]));
    assert!(rules[0]["help"]["text"].as_str().is_some_and(|text| text.len() > 40), "{}", rules[0]);
}

/// What the gate lets pass is no error.
#[test]
fn the_gate_says_what_is_an_error() {
    let changed = SOUND.replace("UINT16", "INT16");
    let raised = changed.replace("revision     = 1", "revision     = 2");
    let desk = Desk::new(&[("old", SOUND), ("new", &changed), ("raised", &raised)]);
    let run = desk.devc(&["diff", "devices/old", "devices/new", "--gate", "--format", "github"]);
    assert!(run.code == Some(1) && run.out.contains("::error"), "{}", run.out);
    let run = desk.devc(&["diff", "devices/old", "devices/raised", "--gate", "--format", "github"]);
    assert!(
        run.code == Some(0) && run.out.contains("::warning") && !run.out.contains("::error"),
        "{}",
        run.out
    );
}

/// Two ESI files are compared by what they say, not by what they are called.
#[test]
fn the_name_of_an_esi_file_is_no_change() {
    let desk = Desk::new(&[("old", SOUND)]);
    desk.devc(&["build", "devices/old", "-o", "out"]).ends(0, &[]);
    desk.put("out/new.xml", desk.read("out/old/old.xml"));
    let run = desk.devc(&["diff", "out/old/old.xml", "out/new.xml"]);
    assert_eq!((run.code, &*run.out), (Some(0), "nothing changes\n"), "{}", run.err);
}

#[test]
fn the_schema_is_printed() {
    let run = Desk::sound().devc(&["schema"]);
    let schema: serde_json::Value = serde_json::from_str(&run.out).expect("JSON");
    assert!(schema["properties"]["objects"].is_object());
}
