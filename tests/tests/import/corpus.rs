//! Real files of vendors, where a folder of them is there: none of them is part of the project.

#![allow(clippy::print_stdout)] // the table of results, for who asks for it by `--nocapture`

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use super::facts;
use super::round_trip::{is_mapping, trip};

/// Where they lie, if they do; `DEVC_CORPUS` names another folder.
fn files() -> Vec<PathBuf> {
    let usual = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/esi-corpus");
    let folder = std::env::var_os("DEVC_CORPUS").map_or(usual, PathBuf::from);
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut files: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|it| it == "xml")).collect();
    files.sort();
    files
}

/// How many devices of a file are tried; all of them with `DEVC_CORPUS_ALL`.
fn most() -> usize {
    if std::env::var_os("DEVC_CORPUS_ALL").is_some() { usize::MAX } else { 2 }
}

#[test]
fn real_files_are_imported_or_refused_with_a_reason() {
    let mut total = (0, 0, 0, 0, 0);
    let mut mappings = (0, 0);
    let mut kinds: BTreeMap<String, usize> = BTreeMap::new();
    let mut faults = Vec::new();
    for path in files() {
        let file = path.file_name().expect("a name").to_string_lossy().into_owned();
        let bytes = fs::read(&path).expect("a file");
        let text = facts::text(&bytes);
        let Ok(document) = roxmltree::Document::parse(&text) else {
            println!("{file}: not well-formed");
            continue;
        };
        let count = facts::devices(&document).len();
        if count == 0 {
            let refusal =
                devc::import::import(&bytes, &file, &Default::default()).expect_err("nothing to import");
            println!("{file}: refused: {}", refusal.why);
            continue;
        }
        for number in 1..=count.min(most()) {
            let start = Instant::now();
            let made = trip(&bytes, number);
            let Ok(made) = made.map_err(|why| faults.push(format!("{file}, device {number}: {why}"))) else {
                continue;
            };
            let lines: usize = made.imported.files.values().map(|text| text.lines().count()).sum();
            let objects = made.imported.files.values().map(|text| text.matches("0x").count()).sum::<usize>();
            let (facts, lost) = (made.facts, made.changed.len());
            let apart = made.changed.iter().filter(|(key, ..)| is_mapping(key)).count();
            mappings = (mappings.0 + made.mappings, mappings.1 + apart);
            println!(
                "{file} {number}/{count}: {facts} facts, {lost} changed, {} silent, report {}/{}, {lines} lines, {objects} indices, {} warnings, {:?}",
                made.silent.len(),
                made.imported.report.lost(),
                made.imported.report.facts,
                made.warnings,
                start.elapsed()
            );
            total =
                (total.0 + 1, total.1 + facts, total.2 + lost, total.3 + made.silent.len(), total.4 + lines);
            made.silent.iter().take(3).for_each(|fact| println!("    silent: {fact}"));
            for (key, was, is) in &made.changed {
                let parts: Vec<&str> = key.split('/').collect();
                let kind = format!(
                    "{}/{}",
                    parts[0],
                    parts[parts.len() - 1].trim_start_matches(|it: char| it.is_ascii_digit())
                );
                *kinds.entry(kind).or_default() += 1;
                if std::env::var_os("DEVC_CORPUS_SAY").is_some() {
                    println!(
                        "    {key}: {was} -> {is:?}{}",
                        if made.silent.iter().any(|it| it.starts_with(&format!("{key}:"))) {
                            " SILENT"
                        } else {
                            ""
                        }
                    );
                }
            }
        }
    }
    let (devices, facts, lost, silent, lines) = total;
    println!("of mapping objects: {} facts, {} changed", mappings.0, mappings.1);
    println!("{devices} devices, {facts} facts, {lost} changed, {silent} silent, {lines} lines; {kinds:#?}");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert_eq!(silent, 0, "facts are lost without a word");
}
