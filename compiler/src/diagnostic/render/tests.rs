//! How messages look.

mod dangerous;

use insta::assert_snapshot;

use super::{Style, text};
use crate::diagnostic::{Diagnostic, Diagnostics, Edit, Help, Level, faults};
use crate::text::{FileId, Location, SourceFile, Sources};

fn sources(files: &[(&str, &str)]) -> Sources {
    let mut sources = Sources::default();
    for (path, text) in files {
        let embedded = path.starts_with('<');
        sources.add(SourceFile { path: (*path).to_owned(), text: (*text).to_owned(), embedded });
    }
    sources
}

/// The place of a word in a file.
fn place(sources: &Sources, file: u32, word: &str) -> Location {
    let text = &sources.get(FileId(file)).expect("a file").text;
    let start = text.find(word).expect("the word");
    Location { file: FileId(file), start: start as u32, end: (start + word.len()) as u32 }
}

#[test]
fn places_in_several_files_with_all_there_is_to_say() {
    let sources = sources(&[
        ("device.toml", "[objects.0x6064]\nunit = \"position\"\nmax = 300\n"),
        ("<profile cia402>", "[objects.0x6064]\ntype = \"UINT8\"\n"),
    ]);
    let mut diagnostic = Diagnostic::new(
        &faults::INVALID_VALUE,
        "the maximum 300 does not fit UINT8, 0 to 255",
        place(&sources, 0, "300"),
        "too large",
    )
    .label(place(&sources, 1, "\"UINT8\""), "the type is set here")
    .label(place(&sources, 0, "0x6064"), "of this object")
    .note("ETG.1020 defines the types")
    .help("give the object a wider type")
    .suggest("or take the greatest value", place(&sources, 0, "300"), "255")
    .suggest("or change the profile", place(&sources, 1, "\"UINT8\""), "\"UINT16\"");
    assert_snapshot!(text(&diagnostic, &sources, Style::Plain), @r#"
    error[invalid-value]: the maximum 300 does not fit UINT8, 0 to 255
     --> device.toml:3:7
      |
    1 | [objects.0x6064]
      |          ------ of this object
    2 | unit = "position"
    3 | max = 300
      |       ^^^ too large
      |
     ::: <profile cia402>:2:8
      |
    2 | type = "UINT8"
      |        ------- the type is set here
      |
      = note: ETG.1020 defines the types
      = help: give the object a wider type
      = help: or change the profile
    help: or take the greatest value
      |
    3 - max = 300
    3 + max = 255
      |
    "#);
    diagnostic.level = Level::Warning;
    assert!(text(&diagnostic, &sources, Style::Plain).starts_with("warning[invalid-value]: the maximum"));
    assert!(text(&diagnostic, &sources, Style::Colour).contains("\u{1b}["));
}

#[test]
fn edits_in_one_help_are_one_diff() {
    let sources = sources(&[("device.toml", "min = 5\nmax = 1\n")]);
    let mut diagnostic = Diagnostic::bare(&faults::INVALID_VALUE, "the limits 5 and 1 are swapped");
    let edit = |word, text: &str| Edit { at: place(&sources, 0, word), text: text.to_owned() };
    diagnostic.helps.push(Help {
        text: "swap them".to_owned(),
        edits: vec![edit("5", "1"), edit("1", "5")],
        sure: false,
    });
    assert_snapshot!(text(&diagnostic, &sources, Style::Plain), @r"
    error[invalid-value]: the limits 5 and 1 are swapped
      |
    help: swap them
     --> device.toml:1:7
      |
    1 ~ min = 1
    2 ~ max = 5
      |
    ");
}

#[test]
fn a_message_without_a_place_is_a_line() {
    let diagnostic = Diagnostic::bare(&faults::MISSING_FILE, "`drive` does not exist");
    assert_snapshot!(text(&diagnostic, &Sources::default(), Style::Plain), @"error[missing-file]: `drive` does not exist");
}

#[test]
fn long_lines_are_cut_around_the_place() {
    let line = format!("list = [{}\"wrong\"{}]\n", "\"right\", ".repeat(100), ", \"right\"".repeat(100));
    let sources = sources(&[("device.toml", &line)]);
    let at = place(&sources, 0, "\"wrong\"");
    let diagnostic = Diagnostic::new(&faults::INVALID_VALUE, "`wrong` means nothing", at, "here").suggest(
        "did you mean `right`?",
        at,
        "\"right\"",
    );
    let message = text(&diagnostic, &sources, Style::Plain);
    assert_snapshot!(message, @r#"
    error[invalid-value]: `wrong` means nothing
     --> device.toml:1:909
      |
    1 | ...ht", "right", "right", "right", "right", "right", "right", "wrong", "right", "right", "right", "right", "right", "right", "right",...
      |                                                               ^^^^^^^ here
      |
      = help: did you mean `right`?
    "#);
}

#[test]
fn no_place_makes_it_panic() {
    let sources = sources(&[("device.toml", "näme = \"Größe\"\r\nµ = 1"), ("empty.toml", "")]);
    for file in 0..3 {
        for start in 0..25 {
            for end in [0, 1, 2, 9, 11, 12, 15, 17, 21, 22, 23, 24, u32::MAX] {
                let at = Location { file: FileId(file), start, end };
                let diagnostic = Diagnostic::new(&faults::UNKNOWN_KEY, "x", at, "y")
                    .label(Location { end: start, ..at }, "z")
                    .suggest("h", at, "ü");
                for style in [Style::Plain, Style::Colour] {
                    assert!(text(&diagnostic, &sources, style).contains("unknown-key"));
                }
            }
        }
    }
}

/// One finding in a line with a character of two UTF-16 units and one of two bytes, in a file whose name
/// needs escaping.
#[cfg(feature = "json")]
fn for_machines() -> (Diagnostics, Sources) {
    let sources =
        sources(&[("a b/déjà,vu.toml", "# 𝛉 and é\nx = \"𝛉é\", y = 300\n"), ("<profile cia402>", "y = 1\n")]);
    let at = place(&sources, 0, "300");
    let mut diagnostics = Diagnostics::default();
    diagnostics.push(
        Diagnostic::new(&faults::UNFIT_VALUE, "300 is 100% too much", at, "this")
            .label(place(&sources, 1, "1"), "not this")
            .note("a note:\nwith two lines")
            .suggest("write 30", at, "30"),
    );
    (diagnostics, sources)
}

#[test]
#[cfg(feature = "json")]
fn json_counts_characters_and_bytes() {
    let (diagnostics, sources) = for_machines();
    let output: serde_json::Value =
        serde_json::from_str(&super::json(&[(&diagnostics, &sources)])).expect("JSON");
    assert_eq!(output["version"], 1);
    let message = &output["diagnostics"][0];
    assert_eq!(message["rule"], "unfit-value");
    assert_eq!(message["level"], "error");
    let label = &message["labels"][0];
    assert_eq!(label["file"], "a b/déjà,vu.toml");
    // `x = "` is 5 characters, `𝛉é` 2 in 6 bytes, `", y = ` 7.
    assert_eq!(label["start"], serde_json::json!({ "line": 2, "column": 15, "offset": 14 + 5 + 6 + 7 }));
    assert_eq!(label["end"]["column"], 18);
    assert_eq!(message["helps"][0]["edits"][0]["replacement"], "30");
}

#[test]
#[cfg(feature = "json")]
fn sarif_counts_utf16_and_names_rules() {
    let (diagnostics, sources) = for_machines();
    let log: serde_json::Value =
        serde_json::from_str(&super::sarif(&[(&diagnostics, &sources)], faults::ALL)).expect("JSON");
    let run = &log["runs"][0];
    assert_eq!(run["columnKind"], "utf16CodeUnits");
    let result = &run["results"][0];
    let index = result["ruleIndex"].as_u64().expect("an index") as usize;
    assert_eq!(run["tool"]["driver"]["rules"][index]["id"], "unfit-value");
    assert_eq!(run["tool"]["driver"]["rules"][index]["name"], "UnfitValue");
    let place = &result["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "a%20b/d%C3%A9j%C3%A0%2Cvu.toml");
    // 𝛉 is two units of UTF-16.
    assert_eq!(place["region"]["startColumn"], 16);
    assert_eq!(result["relatedLocations"][0]["message"]["text"], "not this");
    let fix = &result["fixes"][0]["artifactChanges"][0]["replacements"][0];
    assert_eq!(fix["insertedContent"]["text"], "30");
    assert_eq!(run["invocations"][0]["exitCode"], 1);
}

#[test]
#[cfg(feature = "json")]
fn github_escapes_what_ends_a_command() {
    let (diagnostics, sources) = for_machines();
    assert_eq!(
        super::github(&diagnostics, &sources),
        "::error file=a b/déjà%2Cvu.toml,line=2,endLine=2,col=15,endColumn=18,title=unfit-value::\
         300 is 100%25 too much%0Anote: a note:\\nwith two lines%0Ahelp: write 30\n"
    );
}

/// The place of a message in a large file, and in a line that is too long to be shown.
#[test]
fn what_is_far_away_costs_nothing_and_a_long_line_is_not_shown() {
    let lines = "x = 1\n".repeat(100_000);
    let long = format!("list = [{}]\n", "1, ".repeat(100_000));
    let sources = sources(&[("device.toml", &format!("first = 1\n{lines}{long}last = 1\n"))]);
    let length = sources.get(FileId(0)).expect("a file").text.len() as u32;
    let at = |start: u32, end: u32| Location { file: FileId(0), start, end };
    let diagnostic =
        Diagnostic::new(&faults::UNFIT_VALUE, "three places", at(length - 9, length - 5), "the last")
            .label(at(0, 5), "the first")
            .label(at(10 + 600_000 + 8, 10 + 600_000 + 9), "in the list");
    assert_snapshot!(text(&diagnostic, &sources, Style::Plain), @r"
    error[unfit-value]: three places
          --> device.toml:100003:1
           |
    100003 | last = 1
           | ^^^^ the last
           |
          ::: device.toml:1:1
           |
         1 | first = 1
           | ----- the first
          ::: device.toml:100002:9
           = note: in the list
    ");
}
