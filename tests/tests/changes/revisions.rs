//! Successive revisions of real devices, where a folder of them is there: none of them is part of the project. What changes
//! between them was found by a script and by hand, and is judged as people who run masters see it.

#![allow(clippy::print_stdout)] // to say that there is nothing to try

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use devc::Compilation;
use devc::diff::{Comparison, compare, gate};
use devc::import::{Choice, Imported, import};

/// What changes where: a place and a class.
type Facts = BTreeSet<(String, String)>;

type Row = BTreeMap<String, String>;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared").join(name)
}

/// The rows of a table by the names of its columns; none if it is not there.
fn rows(name: &str) -> Vec<Row> {
    let text = fs::read_to_string(folder("esi-pairs").join(name)).unwrap_or_default();
    let mut lines = text.lines().map(|line| line.split('\t').map(str::to_owned));
    let Some(head) = lines.next() else { return Vec::new() };
    let head: Vec<String> = head.collect();
    lines.map(|row| head.iter().cloned().zip(row).collect()).collect()
}

fn imported(file: &str, device: &str) -> Imported {
    let bytes = fs::read(folder("esi-corpus").join(file)).expect("a file");
    let number = device.parse::<usize>().expect("a number") + 1;
    let choice = Choice { device: Some(number.to_string()), revision: None };
    import(&bytes, "the ESI file", &choice).expect("an import")
}

fn compiled(imported: &Imported) -> Compilation {
    devc::compile(&imported.in_memory("drive"), Path::new("drive"))
}

/// A place as the truth names it: `605A:00` and `rx.1600` as `605A` and `1600`.
fn place(at: &str) -> String {
    let at = at.rsplit('.').next().unwrap_or(at).trim_start_matches("0x").to_uppercase();
    at.strip_suffix(":00").unwrap_or(&at).to_owned()
}

/// The object that a place is in.
fn object(place: &str) -> &str {
    place.split(':').next().unwrap_or(place)
}

/// What devc finds. Sync managers are one place: the truth has their images, devc what is assigned to them.
fn found(comparison: &Comparison) -> Facts {
    let of_devc = comparison.changes.iter().filter(|change| change.kind.rule.name != "changed-text");
    let fact = |change: &devc::diff::Change| {
        let at = change.at.to_string();
        let at = if at.starts_with("sync-managers") { "SM".to_owned() } else { place(&at) };
        (at, change.kind.class.name().to_owned())
    };
    of_devc.map(fact).collect()
}

/// What the truth has, without what follows from another change and is told with it.
fn expected(truth: &[Row], comparison: &Comparison, guesses: &BTreeSet<String>) -> Facts {
    let of_kind = |names: &[&str]| -> BTreeSet<String> {
        let changes = comparison.changes.iter().filter(|change| names.contains(&change.kind.rule.name));
        changes.map(|change| place(&change.at.to_string())).collect()
    };
    let whole = of_kind(&["added-object", "changed-kind"]);
    let mut facts = Facts::new();
    for row in truth {
        let (at, what) = (place(&row["at"]), row["what"].as_str());
        let is_told = at.contains(':') && whole.contains(object(&at))
            || what == "name" && whole.contains(&at)
            || row["class"] == "follows"
            // devc takes a type whose name and width contradict each other by its width, and says so.
            || what.starts_with("type") && guesses.contains(&at);
        if is_told {
            continue;
        }
        let class = if row["class"] == "announcement" { "compatible" } else { &row["class"] };
        let is_of_managers = at.starts_with("SM") || what == "default assignment";
        facts.insert((if is_of_managers { "SM".to_owned() } else { at }, class.to_owned()));
    }
    facts
}

/// The entries whose type an import guessed.
fn guesses(imported: &Imported) -> BTreeSet<String> {
    let notes = imported.report.notes.iter().filter_map(|note| note.what.strip_prefix("the type of "));
    notes.map(place).collect()
}

#[test]
fn successive_revisions_change_as_people_found() {
    let (pairs, truth) = (rows("pairs.tsv"), rows("truth.tsv"));
    if pairs.is_empty() {
        println!("there are no pairs of revisions here: nothing is tried");
    }
    for pair in &pairs {
        let [old, new] =
            ["old", "new"].map(|which| imported(&pair[which], &pair[&format!("{which}_device")]));
        let guesses = &guesses(&old) | &guesses(&new);
        let [old, new] = [compiled(&old), compiled(&new)];
        let (Some(before), Some(after)) = (&old.family, &new.family) else { panic!("{}", pair["pair"]) };
        let comparison = compare(before, after);
        let truth: Vec<Row> = truth.iter().filter(|row| row["pair"] == pair["pair"]).cloned().collect();
        assert!(!truth.is_empty(), "{}", pair["pair"]);
        let (expected, found) = (expected(&truth, &comparison, &guesses), found(&comparison));
        let missed: Vec<_> = expected.difference(&found).collect();
        let invented: Vec<_> = found.difference(&expected).collect();
        assert!(
            missed.is_empty() && invented.is_empty(),
            "{}: {missed:#?} missed, {invented:#?} invented",
            pair["pair"]
        );
        let is_passed = gate(&comparison).iter().all(|gate| gate.complaint().is_none());
        assert_eq!(is_passed, pair["gate"] == "pass", "{}", pair["pair"]);
        let worst = comparison.worst().map(|class| class.name());
        assert_eq!(worst, Some(pair["worst"].as_str()), "{}", pair["pair"]);
    }
}
