//! How the house is built: who looks to whom, and how long files and functions are.
//!
//! The order of the modules is read out of `compiler/docs/architecture.md`, so that the document is true.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod code;
mod links;
mod modules;
mod order;
mod paths;
mod sizes;

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use code::Code;

/// Circles that are in the nature of the thing: a table has values, and a value can be a table. An entry that is no
/// circle any more has to go.
const NATURAL: &[&str] = &[
    "compiler/src/raw/decode/access.rs: looks in a circle to `view`",
    "compiler/src/raw/decode/view.rs: looks in a circle to `access`",
];

/// Something that is not as it should be.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Fault {
    file: String,
    line: usize,
    what: String,
}

impl Fault {
    /// Its name in [`NATURAL`].
    fn key(&self) -> String {
        format!("{}: {}", self.file, self.what)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.file, self.line, self.what)
    }
}

/// A reader who follows a link gets somewhere, and every chapter of the book is in its contents.
#[test]
fn links_lead_somewhere() {
    let documents = links::documents();
    let faults: Vec<Fault> = documents.iter().flat_map(|path| links::lost(path)).collect();
    check(&faults, &[]);
    let summary = fs::read_to_string(root().join("docs/src/SUMMARY.md")).expect("contents");
    let chapters = documents.iter().filter(|path| path.starts_with(root().join("docs/src")));
    let names = chapters.filter_map(|path| path.file_name()?.to_str()).filter(|name| *name != "SUMMARY.md");
    let missing: Vec<&str> = names.filter(|name| !summary.contains(&format!("({name})"))).collect();
    assert!(missing.is_empty(), "the contents lack {missing:?}");
}

#[test]
fn modules_look_only_downwards() {
    let document = fs::read_to_string(root().join("compiler/docs/architecture.md")).expect("the document");
    let order = order::stated(&document).expect("the document states an order");
    let compiler = modules::read(&sources("compiler/src"));
    let mut faults = order::unlisted(&compiler, &order);
    faults.extend(order::upward(&compiler, &order));
    faults.extend(order::circles(&compiler));
    for folder in ["cli/src", "macros/src", "virtual/src"] {
        faults.extend(order::circles(&modules::read(&sources(folder))));
    }
    check(&faults, NATURAL);
}

#[test]
fn files_and_functions_are_short() {
    let written = ["compiler/src", "cli/src", "macros/src", "start-up/src", "runtime/src", "virtual/src"];
    let tests = [
        "compiler/tests",
        "cli/tests",
        "macros/tests",
        "start-up/tests",
        "runtime/tests",
        "virtual/tests",
        "tests",
        "fuzz",
        "examples",
    ];
    let written = written.iter().flat_map(|folder| sources(folder));
    let (tests_inside, code): (Vec<Code>, Vec<Code>) = written.partition(Code::is_test);
    let tests = tests.iter().flat_map(|folder| sources(folder)).chain(tests_inside);
    let mut faults: Vec<Fault> = code.iter().flat_map(sizes::too_long).collect();
    faults.extend(tests.filter_map(|code| sizes::too_long_a_test(&code)));
    check(&faults, &[]);
}

/// Says what is wrong and not natural, and what is natural without being there.
fn check(faults: &[Fault], natural: &[&str]) {
    let keys: Vec<String> = faults.iter().map(Fault::key).collect();
    let wrong = faults.iter().filter(|fault| !natural.contains(&fault.key().as_str()));
    let wrong: Vec<String> = wrong.map(Fault::to_string).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let gone: Vec<&&str> = natural.iter().filter(|key| !keys.iter().any(|found| found == **key)).collect();
    assert!(gone.is_empty(), "listed as natural, and not there: {gone:?}");
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace").to_owned()
}

/// The files of Rust in a folder of the workspace, by name.
fn sources(folder: &str) -> Vec<Code> {
    let mut files = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() && !path.ends_with("target") {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    let code = files.iter().map(|path| {
        let text = fs::read_to_string(path).expect("text");
        Code::new(path.strip_prefix(root()).expect("in the workspace"), &text)
    });
    code.collect()
}
