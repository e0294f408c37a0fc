//! `devc fmt` changes how a description is written, never what it says: shipped descriptions, profiles, the examples
//! of all rules, and what random edits make of them are compiled before and after.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may
#![cfg(feature = "cli")]

#[path = "../rules/example.rs"]
#[expect(dead_code, reason = "only the files of examples are of use here")]
mod example;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use devc::diagnostic::faults;
use devc::emit::{self, Options};
use devc::format::format;
use devc::lint;
use devc::source::Memory;

/// The files of a description by name.
type Files = BTreeMap<String, String>;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn toml_files(folder: &Path) -> Files {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let files = entries.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    files.map(|path| (name(&path), fs::read_to_string(&path).expect("a text"))).collect()
}

fn shipped() -> Vec<Files> {
    let folders = fs::read_dir(root().join("devices")).expect("a folder");
    let mut folders: Vec<PathBuf> = folders.map(|entry| entry.expect("an entry").path()).collect();
    folders.push(root().join("compiler/tests/hundred"));
    folders.sort();
    folders.iter().map(|folder| toml_files(folder)).filter(|files| !files.is_empty()).collect()
}

fn examples() -> Vec<Files> {
    let rules = faults::ALL.iter().copied().chain(lint::ALL.iter().map(|lint| lint.rule));
    let examples = rules.flat_map(|rule| {
        ["Fires", "Silent"].into_iter().filter_map(|heading| example::example(rule.docs, heading))
    });
    examples.map(|text| example::files(text).into_iter().collect()).collect()
}

/// Everything that devc says of a description and makes of it, without the places in the text; in capitals, since
/// messages quote numbers as they are written. Marks of provenance are listed as the keys are written, so of outputs
/// for people it is all words, and of the ESI each byte.
fn meaning(files: &Files) -> (Vec<String>, Vec<String>) {
    let memory = files.iter().fold(Memory::new(), |memory, (name, text)| {
        memory.with(Path::new("example").join(name), text.clone())
    });
    let compilation = devc::compile(&memory, Path::new("example"));
    let said = compilation.diagnostics.iter().map(|it| {
        let mut labels: Vec<&str> = it.labels.iter().map(|label| label.text.as_str()).collect();
        labels.sort_unstable();
        let helps: Vec<&str> = it.helps.iter().map(|help| help.text.as_str()).collect();
        let said =
            format!("{:?} {} {} {labels:?} {:?} {helps:?}", it.level, it.rule.name, it.message, it.notes);
        said.to_uppercase()
    });
    let mut said: Vec<String> = said.collect();
    said.sort();
    let made = compilation.family.as_ref().map(|family| emit::emit(family, emit::ALL, &Options::default()));
    let mut made: Vec<String> = made.into_iter().flat_map(|files| files.0).flat_map(words).collect();
    made.sort();
    (said, made)
}

fn words((name, content): (String, Vec<u8>)) -> Vec<String> {
    let text = String::from_utf8_lossy(&content).into_owned();
    if name.ends_with(".xml") {
        return vec![text];
    }
    let words = text.split(|c: char| !c.is_alphanumeric()).map(str::to_uppercase);
    words.filter(|word| !word.is_empty()).collect()
}

/// Lays out all files that are TOML, and asserts that doing it again changes nothing.
fn laid_out(files: &Files) -> Files {
    let lay_out = |(name, text): (&String, &String)| {
        let new = match format(name, text) {
            Ok(once) => {
                let twice = format(name, &once).expect("what was laid out is TOML");
                assert_eq!(twice, once, "{name} laid out twice, from\n{text}");
                once
            }
            Err((diagnostics, _)) => {
                assert!(diagnostics.has_errors());
                text.clone()
            }
        };
        (name.clone(), new)
    };
    files.iter().map(lay_out).collect()
}

#[track_caller]
fn means_the_same(files: &Files) {
    let new = laid_out(files);
    if *files != new {
        let (before, after) = (meaning(files), meaning(&new));
        assert_eq!(before.0, after.0, "{new:#?}");
        assert!(before.1 == after.1, "the outputs differ of {new:#?}");
    }
}

#[test]
fn what_is_shipped_is_laid_out() {
    let profiles = toml_files(&root().join("compiler/profiles"));
    assert_eq!(profiles.len(), 2);
    let devices = fs::read_dir(root().join("devices")).expect("a folder");
    let devices = devices.map(|entry| toml_files(&entry.expect("an entry").path()));
    for files in devices.chain([profiles]) {
        for (name, text) in &files {
            let new = format(name, text).expect("TOML");
            assert!(new == *text, "{name} is not laid out: run `devc fmt`");
        }
    }
}

#[test]
fn examples_mean_the_same() {
    let examples = examples();
    assert!(examples.len() > 100, "{}", examples.len());
    examples.iter().for_each(means_the_same);
}

#[test]
fn edited_descriptions_mean_the_same() {
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    for files in shipped() {
        for round in 0..2 {
            let mut edited = files.clone();
            for _ in 0..25 {
                let place = random.below(edited.len());
                let text = edited.values_mut().nth(place).expect("a file");
                // most of what is left out or doubled ends in an error, which leaves no outputs to compare
                let kind =
                    if round == 0 { LAYOUT + random.below(KINDS - LAYOUT) } else { random.below(KINDS) };
                let new = edit(text, kind, &mut random);
                // what is not TOML is left alone, which needs no compiler to see
                if format("a.toml", &new).is_ok() {
                    *text = new;
                }
            }
            means_the_same(&edited);
        }
    }
}

/// Layout alone, of every file and of many edits: each is TOML and laid out in one step, or it is refused.
#[test]
fn a_layout_is_whole_in_one_step() {
    let mut random = Random(7);
    for (name, text) in shipped().into_iter().flatten() {
        for _ in 0..4 {
            let mut edited = text.clone();
            for _ in 0..3 {
                let kind = random.below(KINDS);
                edited = edit(&edited, kind, &mut random);
            }
            laid_out(&[(name.clone(), edited)].into());
        }
    }
}

/// How many kinds of edits there are, and the first of those that are about layout alone.
const KINDS: usize = 12;
const LAYOUT: usize = 3;

/// An edit of a line such as people make, some of which leave no TOML.
fn edit(text: &str, kind: usize, random: &mut Random) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    if lines.len() < 2 {
        return text.to_owned();
    }
    let place = random.below(lines.len() - 1);
    match kind {
        0 => _ = lines.remove(place),
        1 => lines.insert(place, lines[place].clone()),
        2 => {
            let end = lines[place].char_indices().map(|(at, _)| at).nth(random.below(20)).unwrap_or_default();
            lines[place].truncate(end);
        }
        3 => lines.swap(place, place + 1),
        4 => lines.insert(place, String::new()),
        5 => lines.insert(place, "   # a comment = 1".to_owned()),
        6 => lines[place].insert_str(0, "\t  "),
        7 => lines[place] = lower_hex(&lines[place]),
        8 => lines[place] = lines[place].replacen(" = ", "=", 1),
        9 => lines[place].push_str("   # behind"),
        10 => lines[place] = lines[place].replace(", ", ",\n  "),
        _ => {
            lines[place] =
                lines[place].replace("{ ", "{").replace("[\"", "[\n\n# x\n\"").replace("\"]", "\" , ]")
        }
    }
    lines.join("\n") + "\n"
}

/// A line with its numbers in small letters.
fn lower_hex(line: &str) -> String {
    let parts = line.split("0x").enumerate();
    let lower = parts.map(|(place, part)| {
        let digits = part.len() - part.trim_start_matches(|c: char| c.is_ascii_hexdigit()).len();
        let (number, rest) = part.split_at(if place == 0 { 0 } else { digits });
        number.to_lowercase() + rest
    });
    lower.collect::<Vec<_>>().join("0x")
}

/// The same numbers in each run (xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % end.max(1) as u64).unwrap_or(0)
    }
}
