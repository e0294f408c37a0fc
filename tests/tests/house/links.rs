//! Links between documents: each leads to a file that is there, and to a heading that it has.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{Fault, root};

/// The documents that people write, and those that are made from the code and belong to them.
pub(crate) fn documents() -> Vec<PathBuf> {
    let folders = [".", "compiler/docs", "docs/src", "examples"];
    let files = folders.iter().flat_map(|folder| fs::read_dir(root().join(folder)).expect("a folder"));
    let paths = files.map(|file| file.expect("a file").path());
    let mut paths: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|extension| extension == "md")).collect();
    paths.sort();
    paths
}

/// Links that lead nowhere.
pub(crate) fn lost(path: &Path) -> Vec<Fault> {
    let text = fs::read_to_string(path).expect("a document");
    let folder = path.parent().expect("a folder");
    let shown = path.strip_prefix(root()).unwrap_or(path).display().to_string();
    let mut faults = Vec::new();
    for (number, line) in prose(&text) {
        let included = line.split("{{#include ").skip(1).filter_map(|rest| rest.split("}}").next());
        let included = included.map(|file| (file, None));
        for (file, anchor) in links(&line).into_iter().chain(included) {
            let target = if file.is_empty() { path.to_owned() } else { folder.join(file) };
            let is_there = target.exists() && anchor.is_none_or(|anchor| has_anchor(&target, anchor));
            if !is_there {
                let what =
                    format!("leads to `{file}{}`", anchor.map_or(String::new(), |one| format!("#{one}")));
                faults.push(Fault { file: shown.clone(), line: number, what });
            }
        }
    }
    faults
}

/// The lines that are no code, numbered from 1.
fn prose(text: &str) -> Vec<(usize, String)> {
    let mut is_code = false;
    let mut lines = Vec::new();
    for (line, number) in text.lines().zip(1..) {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code && !line.starts_with("    ") {
            // between backticks are no links
            let words = line.split('`').step_by(2);
            lines.push((number, words.collect::<Vec<_>>().join("`")));
        } else if line.starts_with("{{#include ") {
            lines.push((number, line.to_owned()));
        }
    }
    lines
}

/// The links of a line to other places of the project: the file, and the place in it.
fn links(line: &str) -> Vec<(&str, Option<&str>)> {
    let targets = line.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let inside = targets.filter(|target| !target.contains("://") && !target.starts_with("mailto:"));
    inside
        .map(|target| target.split_once('#').map_or((target, None), |(file, at)| (file, Some(at))))
        .collect()
}

/// Whether a document has a heading, or another place, of this name.
fn has_anchor(path: &Path, anchor: &str) -> bool {
    let text = fs::read_to_string(path).unwrap_or_default();
    let included = text.split("{{#include ").skip(1).filter_map(|rest| rest.split("}}").next());
    let folder = path.parent().expect("a folder");
    text.contains(&format!("id=\"{anchor}\""))
        || prose_headings(&text).contains(anchor)
        || included.into_iter().any(|file| has_anchor(&folder.join(file), anchor))
}

/// What links call the headings of a document, as GitHub and mdBook do.
fn prose_headings(text: &str) -> BTreeSet<String> {
    let mut is_code = false;
    let mut found = BTreeSet::new();
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if line.starts_with('#') && !is_code {
            let title = line.trim_start_matches('#').trim().to_lowercase();
            let kept = title.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
            found.insert(kept.map(|c| if c == ' ' { '-' } else { c }).collect());
        }
    }
    found
}

#[test]
fn links_are_read() {
    let text = "# A `b` c!\n[x](y.md#z) and [w](https://q) `[v](u)`\n```\n[t](s)\n```\n";
    let found: Vec<_> = prose(text).into_iter().map(|(_, line)| line).collect();
    assert_eq!(found.iter().flat_map(|line| links(line)).collect::<Vec<_>>(), [("y.md", Some("z"))]);
    assert!(prose_headings(text).contains("a-b-c"));
}
