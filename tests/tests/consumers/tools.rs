//! Programs that the tests ask.

use std::path::Path;
use std::process::{Command, Output};

/// The first of these programs that is there.
pub(crate) fn tool(names: &[&'static str]) -> Option<&'static str> {
    let found = names
        .iter()
        .find(|name| Command::new(name).arg("--version").output().is_ok_and(|it| it.status.success()));
    if found.is_none() {
        eprintln!("skipped, since there is none of {names:?}");
    }
    found.copied()
}

/// Whether Python has a module.
pub(crate) fn has_module(python: &str, module: &str) -> bool {
    let asked = Command::new(python).args(["-c", &format!("import {module}")]).output();
    let has = asked.is_ok_and(|it| it.status.success());
    if !has {
        eprintln!("skipped, since Python has no {module}");
    }
    has
}

/// Runs a program in a folder; what it says if it fails is the failure.
pub(crate) fn run(folder: &Path, program: &str, arguments: &[&str]) -> Output {
    let output = Command::new(program).args(arguments).current_dir(folder).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let said = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    let end = |text: &str| text.lines().take(40).collect::<Vec<_>>().join("\n");
    assert!(output.status.success(), "{program} {arguments:?}:\n{}\n{}", end(&said[1]), end(&said[0]));
    output
}

/// Holds what a program printed against what it has to print.
pub(crate) fn compare(what: &str, output: &Output, expected: &str) {
    let found = std::str::from_utf8(&output.stdout).unwrap();
    let mut pairs = found.lines().zip(expected.lines());
    if let Some((found, expected)) = pairs.find(|(found, expected)| found != expected) {
        panic!("{what}\n found    {found}\n expected {expected}");
    }
    assert_eq!(found.lines().count(), expected.lines().count(), "lines of {what}");
}
