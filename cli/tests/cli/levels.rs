//! What a team can say about findings: how bad they are, which are known, which a machine may mend.

use crate::{Desk, SOUND};

/// A sound description in which each of these objects counts one entry too many.
fn doubtful(indices: &[&str]) -> String {
    let objects = indices.iter().map(|index| {
        format!(
            "\n[objects.{index}]\nname = \"Gains {index}\"\n[objects.{index}.entries]\n\
             0 = {{ default = 3 }}\n1 = {{ name = \"Gain\", type = \"UINT16\" }}\n"
        )
    });
    SOUND.to_owned() + &objects.collect::<String>()
}

#[test]
fn levels_are_set_for_rules_and_groups() {
    let desk = Desk::new(&[("drive", &doubtful(&["0x2001"]))]);
    desk.devc(&["check"]).ends(0, &["warning[contradicted-count]"]);
    let denied = ["error[contradicted-count]", "`contradicted-count` is set to \"deny\" on the command line"];
    desk.devc(&["check", "--deny", "contradicted-count"]).ends(1, &denied);
    desk.devc(&["check", "-A", "dictionary"]).ends(0, &["no findings"]);
    desk.devc(&["check", "-A", "dictionary", "-D", "contradicted-count"]).ends(1, &denied);
    desk.devc(&["build", "-D", "contradicted-count"]).ends(1, &["nothing made"]);
}

#[test]
fn a_level_that_makes_no_sense_is_refused() {
    let desk = Desk::sound();
    desk.devc(&["check", "-A", "contradicted-cuont"]).ends(2, &["did you mean `contradicted-count`?"]);
    desk.devc(&["check", "-A", "unknown-key"]).ends(2, &["the level of `unknown-key` cannot be changed"]);
}

#[test]
fn a_baseline_hides_what_is_known_and_shows_what_is_new() {
    let desk = Desk::new(&[("drive", &doubtful(&["0x2001"]))]);
    desk.devc(&["check", "--baseline", "known.json"]).ends(2, &["known.json", "--update-baseline"]);
    desk.devc(&["check", "--baseline", "known.json", "--update-baseline"]).ends(0, &["1 known finding"]);
    desk.devc(&["check", "--baseline", "known.json", "--deny-warnings"]).ends(0, &["no new findings"]);
    // Lines that move do not matter, a second finding does.
    desk.put("devices/drive/device.toml", format!("# moved\n\n{}", doubtful(&["0x2001", "0x2002"])));
    let run = desk.devc(&["check", "--baseline", "known.json", "--deny-warnings"]);
    run.ends(1, &["0x2002:00", "devices/drive: 1 warning"]);
    assert!(!run.err.contains("0x2001:00"), "{}", run.err);
}

#[test]
fn a_baseline_that_is_none_is_refused() {
    let desk = Desk::sound();
    desk.put("known.json", "{ \"version\": 1");
    desk.devc(&["check", "--baseline", "known.json"]).ends(2, &["`known.json` is not a baseline"]);
}

#[test]
fn fixes_keep_what_the_author_wrote() {
    let text = SOUND
        .replace("access = ", "# why not\nacess\t=  ")
        .replace("name   = \"Speed\"", "nmae = \"Speed\" # é");
    let desk = Desk::new(&[("drive", &text)]);
    desk.devc(&["check"]).ends(1, &["error[unknown-key]"]);
    desk.devc(&["check", "--fix"]).ends(0, &["devices/drive: made 2 edits", "no findings"]);
    let fixed = text.replace("acess\t", "access\t").replace("nmae", "name");
    assert_eq!(desk.read("devices/drive/device.toml"), fixed);
    assert_eq!(desk.list("devices/drive"), ["device.toml"]);
}

#[test]
fn fixes_leave_alone_what_is_open_to_doubt() {
    let text = doubtful(&["0x2001"]);
    let desk = Desk::new(&[("drive", &text)]);
    desk.devc(&["check", "--fix"]).ends(0, &["devices/drive: 1 warning"]);
    assert_eq!(desk.read("devices/drive/device.toml"), text);
}

#[test]
fn machines_get_their_formats_on_the_standard_output() {
    let desk = Desk::new(&[("drive", &doubtful(&["0x2001"]))]);
    let json = desk.devc(&["check", "--format", "json"]);
    assert!(json.out.starts_with("{\n  \"version\": 1,"), "{}", json.out);
    assert!(json.out.contains("\"rule\": \"contradicted-count\"") && json.err.is_empty());
    let sarif = desk.devc(&["check", "--format", "sarif"]);
    assert!(sarif.out.contains("\"version\": \"2.1.0\"") && sarif.err.is_empty());
    let github = desk.devc(&["check", "--format", "github"]);
    assert!(github.out.starts_with("::warning file=devices/drive/device.toml,line="), "{}", github.out);
}
