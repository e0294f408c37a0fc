//! The errata of the shipped descriptions answer what rules find in the manuals: without them, each finding is
//! there again, no more and no less.

#![cfg(test)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use devc::source::Disk;

/// How often each rule is named.
type Counts = BTreeMap<String, usize>;

/// The findings in a copy of a description from which the errata were taken, and those errata.
fn without_errata(name: &str) -> (Counts, Counts) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(name);
    let copy = tempfile::tempdir().expect("a temporary folder");
    let mut errata = Counts::new();
    for entry in fs::read_dir(&folder).expect("the description is there") {
        let path = entry.expect("an entry").path();
        let text = fs::read_to_string(&path).expect("a file");
        let kept = match path.file_name() {
            Some(file) if file == "errata.toml" => {
                for line in text.lines().filter_map(|line| line.strip_prefix("rule")) {
                    let rule = line.trim_start_matches([' ', '=']).trim_matches('"');
                    *errata.entry(rule.to_owned()).or_default() += 1;
                }
                String::new()
            }
            _ => text,
        };
        fs::write(copy.path().join(path.file_name().expect("a name")), kept).expect("a file");
    }
    let compilation = devc::compile(&Disk, copy.path());
    let mut findings = Counts::new();
    for diagnostic in compilation.diagnostics.iter() {
        *findings.entry(diagnostic.rule.name.to_owned()).or_default() += 1;
    }
    (findings, errata)
}

#[test]
fn each_erratum_answers_one_finding() {
    for name in ["c887", "s700", "pmc-sc6"] {
        let (findings, errata) = without_errata(name);
        assert_eq!(findings, errata, "{name}");
        assert!(!errata.is_empty(), "{name} has errata");
    }
}
