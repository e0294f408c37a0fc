//! Every rule's documentation is its test: the first example fires it and nothing else, the second is silent.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod example;
mod messages;
mod more;

use std::fs;
use std::path::Path;

use devc::diagnostic::{Rule, faults};
use devc::lint;
use example::{example, fired};

fn rules() -> impl Iterator<Item = &'static Rule> {
    faults::ALL.iter().copied().chain(lint::ALL.iter().map(|lint| lint.rule))
}

#[test]
fn examples_hold() {
    let mut wrong = Vec::new();
    for rule in rules() {
        for (heading, expected) in [("Fires", vec![rule.name]), ("Silent", vec![])] {
            match example(rule.docs, heading) {
                None => wrong.push(format!("{}: no example under `## {heading}`", rule.name)),
                Some(example) => {
                    let fired = fired(rule.name, example);
                    if fired != expected {
                        wrong.push(format!("{}: {heading} gives {fired:?}", rule.name));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_file_is_a_rule_of_its_name() {
    for (folder, rules) in [
        ("diagnostic/faults", faults::ALL.to_vec()),
        ("lint/rules", lint::ALL.iter().map(|lint| lint.rule).collect()),
    ] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(folder);
        let files = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path());
        let files = files.filter_map(|path| Some(path.file_stem()?.to_str()?.replace('_', "-")));
        let mut files: Vec<String> = files.filter(|name| name != "mod").collect();
        files.sort();
        let names: Vec<&str> = rules.iter().map(|rule| rule.name).collect();
        assert_eq!(files, names, "one file each, and a line in the list");
    }
}

#[test]
fn rules_are_sorted_and_named_once() {
    let names: Vec<&str> = lint::ALL.iter().map(|lint| lint.rule.name).collect();
    assert!(names.is_sorted(), "lint::rules lists rules by name: {names:?}");
    let mut all: Vec<&str> = rules().map(|rule| rule.name).collect();
    all.sort_unstable();
    let count = all.len();
    all.dedup();
    assert_eq!(all.len(), count, "two rules share a name");
}
