//! Every rule's documentation is its test: the first example fires it and nothing else, the second is silent.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

use std::fs;
use std::path::Path;

use devc::Compilation;
use devc::diagnostic::render::{Style, text};
use devc::diagnostic::{Group, Rule, faults};
use devc::lint;
use devc::source::Memory;

/// What every example is completed with, unless it brings its own.
const HEAD: &str = "\n[device]\nname = \"Example\"\nvendor = \"Example\"\n";
const IDENTITY: &str = "\n[identity]\nvendor-id = 0x76D\nproduct-code = 3\nrevision = 1\n";

fn rules() -> impl Iterator<Item = &'static Rule> {
    faults::ALL.iter().copied().chain(lint::ALL.iter().map(|lint| lint.rule))
}

/// The example under a heading.
fn example<'d>(docs: &'d str, heading: &str) -> Option<&'d str> {
    let (_, section) = docs.split_once(&format!(" ## {heading}\n"))?;
    let (_, fence) = section.split_once("```toml\n")?;
    fence.split_once(" ```").map(|(example, _)| example)
}

/// The files of an example: the main one, and those that a line `# file: name` starts.
fn files(example: &str) -> Vec<(String, String)> {
    let lines = example.lines().map(|line| line.strip_prefix(' ').unwrap_or(line));
    let mut file = ("device.toml".to_owned(), String::new());
    let mut files = Vec::new();
    for line in lines {
        match line.strip_prefix("# file: ") {
            Some(name) => files.push(std::mem::replace(&mut file, (name.to_owned(), String::new()))),
            None => {
                file.1.push_str(line);
                file.1.push('\n');
            }
        }
    }
    files.push(file);
    let whole: String = files.iter().map(|(_, text)| text.as_str()).collect();
    let missing = [("[device]", HEAD), ("[identity]", IDENTITY)];
    let missing = missing.into_iter().filter(|(header, _)| !whole.contains(header));
    files.iter_mut().take(1).for_each(|(_, main)| main.extend(missing.clone().map(|(_, text)| text)));
    files
}

/// What devc says of an example.
fn compiled(example: &str) -> Compilation {
    let memory = files(example).into_iter().fold(Memory::default(), |memory, (name, text)| {
        memory.with(Path::new("example").join(name), text.into_bytes())
    });
    devc::compile(&memory, Path::new("example"))
}

/// The rules that fire on an example.
fn fired(example: &str) -> Vec<&'static str> {
    let diagnostics = compiled(example).diagnostics;
    let mut names: Vec<&str> = diagnostics.iter().map(|diagnostic| diagnostic.rule.name).collect();
    names.dedup();
    names
}

/// The messages about an example as people read them.
fn messages(example: &str) -> Vec<String> {
    let Compilation { diagnostics, sources, .. } = compiled(example);
    diagnostics.iter().map(|diagnostic| text(diagnostic, &sources, Style::Plain)).collect()
}

#[test]
fn examples_hold() {
    let mut wrong = Vec::new();
    for rule in rules() {
        for (heading, expected) in [("Fires", vec![rule.name]), ("Silent", vec![])] {
            match example(rule.docs, heading) {
                None => wrong.push(format!("{}: no example under `## {heading}`", rule.name)),
                Some(example) => {
                    let fired = fired(example);
                    if fired != expected {
                        wrong.push(format!("{}: {heading} gives {fired:?}", rule.name));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What every rule says of its first example, to be read as a user would: a file a group.
#[test]
fn messages_are_as_reviewed() {
    for group in Group::ALL {
        let mut members: Vec<&Rule> = rules().filter(|rule| rule.group == group).collect();
        members.sort_unstable_by_key(|rule| rule.name);
        let messages = members.iter().filter_map(|rule| example(rule.docs, "Fires")).flat_map(messages);
        let settings = {
            let mut settings = insta::Settings::clone_current();
            settings.set_omit_expression(true);
            settings
        };
        let text = messages.collect::<Vec<_>>().join("\n\n");
        settings.bind(|| insta::assert_snapshot!(group.name(), text));
    }
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
