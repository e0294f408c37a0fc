//! A description with a hundred faults gets a hundred messages in one run: none is missing, none comes twice, none
//! only follows from another.
//!
//! In `hundred/`, a comment `#~ rule` at the end of a line says which rules find something there.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

use std::path::Path;

use devc::source::{Disk, Sources};

/// A file's name, a line, and a rule.
type Finding = (String, usize, String);

/// The lines of the description that the comments say something about.
fn expected(sources: &Sources) -> Vec<Finding> {
    let described = sources.iter().map(|(_, file)| file).filter(|file| !file.embedded);
    let mut findings: Vec<Finding> = described
        .flat_map(|file| {
            let lines = file.text.lines().enumerate();
            lines
                .flat_map(|(line, text)| {
                    let rules = text.split_once("#~ ").map_or("", |(_, rules)| rules);
                    rules
                        .split(' ')
                        .filter(|rule| !rule.is_empty())
                        .map(move |rule| (line + 1, rule.to_owned()))
                })
                .map(|(line, rule)| (name(&file.path), line, rule))
        })
        .collect();
    findings.sort();
    findings
}

fn name(path: &str) -> String {
    Path::new(path).file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

#[test]
fn each_of_a_hundred_faults_has_its_message() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hundred");
    let compilation = devc::compile(&Disk, &folder);
    let mut found: Vec<Finding> = Vec::new();
    let mut places = Vec::new();
    for diagnostic in compilation.diagnostics.iter() {
        let at = diagnostic.at().expect("a finding has a place");
        let file = compilation.sources.get(at.file).expect("the place is in a file");
        let before = &file.text[..usize::try_from(at.start).expect("files are small")];
        found.push((name(&file.path), before.matches('\n').count() + 1, diagnostic.rule.name.to_owned()));
        places.push((at, diagnostic.rule.name, diagnostic.message.clone()));
    }
    assert!(places.windows(2).all(|pair| pair[0] < pair[1]), "sorted, and none twice");
    found.sort();
    let expected = expected(&compilation.sources);
    assert!(expected.len() >= 100, "only {} faults", expected.len());
    let missing: Vec<_> = expected.iter().filter(|finding| !found.contains(finding)).collect();
    let extra: Vec<_> = found.iter().filter(|finding| !expected.contains(finding)).collect();
    assert!(found == expected, "missing: {missing:#?}\nnot expected: {extra:#?}");
}
