//! Every format against every kind of dangerous character, in all that a message consists of.

use super::{place, sources};
use crate::diagnostic::render::{Style, text};
#[cfg(feature = "json")]
use crate::diagnostic::render::{github, json, sarif};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::text::{Location, SourceFile, Sources};

/// Characters that a terminal obeys or does not show, one of each kind, and lines that a runner would take for commands.
const DANGEROUS: &str = "a\0\u{7}\u{1B}[31m\u{7F}\u{9B}31m\u{85}\r\u{2028}\u{202E}\u{200F}\u{200B}\u{FFFE}\u{E0041}\n::error::b\n\tc %0A d\n##[error]e";

/// A message with something dangerous in all of it, about a file that has it in its name and its text.
fn dangerous() -> (Diagnostics, Sources) {
    let text = format!("# {DANGEROUS}\nkey = \"{DANGEROUS}\"\n");
    let mut sources = sources(&[("plain.toml", "x = 1\n")]);
    let path = format!("{DANGEROUS}/device.toml");
    let file = sources.add(SourceFile { path, text, embedded: false });
    let at = Location { start: 2, end: 5, ..place(&sources, file.0, "key") };
    let diagnostic =
        Diagnostic::new(&faults::UNFIT_VALUE, DANGEROUS, place(&sources, file.0, "key"), DANGEROUS)
            .label(at, DANGEROUS)
            .label(place(&sources, 0, "x"), DANGEROUS)
            .note(DANGEROUS)
            .help(DANGEROUS)
            .suggest(DANGEROUS, place(&sources, file.0, "key"), DANGEROUS)
            .fix(DANGEROUS, place(&sources, 0, "x"), DANGEROUS);
    let mut diagnostics = Diagnostics::default();
    diagnostics.push(diagnostic);
    diagnostics.push(Diagnostic::bare(&faults::MISSING_FILE, DANGEROUS));
    (diagnostics, sources)
}

fn odd(text: &str) -> Option<char> {
    text.chars().find(|c| crate::text::characters::hazard(*c).is_some())
}

#[test]
fn text_moves_no_terminal_and_starts_no_command() {
    let (diagnostics, sources) = dangerous();
    for diagnostic in diagnostics.iter() {
        let plain = text(diagnostic, &sources, Style::Plain);
        assert_eq!(odd(&plain), None, "{plain:?}");
        let coloured = text(diagnostic, &sources, Style::Colour);
        let ends =
            |code: &str| code.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';').starts_with('m');
        for (place, part) in coloured.split('\u{1B}').enumerate() {
            assert_eq!(odd(part), None, "{part:?}");
            assert!(place == 0 || part.strip_prefix('[').is_some_and(ends), "{part:?} is no colour");
        }
        assert!(!coloured.contains("\u{1B}[31m"), "the text's own colour is none");
        let commands = plain.lines().filter(|line| line.starts_with("::") || line.starts_with("##["));
        assert_eq!(commands.count(), 0, "{plain}");
    }
}

#[test]
#[cfg(feature = "json")]
fn each_message_is_one_command_for_github() {
    let (diagnostics, sources) = dangerous();
    let commands = github(&diagnostics, &sources);
    assert_eq!(odd(&commands), None, "{commands:?}");
    assert_eq!(commands.lines().count(), 2, "{commands}");
    assert!(commands.lines().all(|line| line.starts_with("::error ")), "{commands}");
}

#[test]
#[cfg(feature = "json")]
fn programs_get_what_was_said_and_terminals_nothing_to_obey() {
    let (diagnostics, sources) = dangerous();
    let runs = [(&diagnostics, &sources)];
    let (json, sarif) = (json(&runs), sarif(&runs, faults::ALL));
    assert_eq!((odd(&json), odd(&sarif)), (None, None));
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let message = &json["diagnostics"][0];
    for said in [
        &message["message"],
        &message["labels"][0]["text"],
        &message["notes"][0],
        &message["helps"][1]["text"],
        &message["helps"][1]["edits"][0]["replacement"],
    ] {
        assert_eq!(said, DANGEROUS);
    }
    let sarif: serde_json::Value = serde_json::from_str(&sarif).expect("JSON");
    let result = &sarif["runs"][0]["results"][0];
    assert_eq!(result["relatedLocations"][0]["message"]["text"], DANGEROUS);
    let uri = &result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
    assert!(uri.as_str().is_some_and(|uri| uri.starts_with("a%00%07%1B%5B31m")), "{uri}");
}
