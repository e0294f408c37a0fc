//! Documents that are made from the code are up to date.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

use std::fs;
use std::path::Path;

/// Compares a document with what it should be; `cargo accept` rewrites it.
fn is_current(path: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let current = fs::read_to_string(&path).unwrap_or_default();
    if current != text && std::env::var_os("DEVC_BLESS").is_some() {
        fs::write(&path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        return;
    }
    assert!(current == text, "{} is out of date; `cargo accept` rewrites it", path.display());
}

#[test]
fn reference_of_the_rules() {
    is_current("docs/rules.md", &devc::rules::reference());
}

#[test]
fn reference_of_the_changes() {
    is_current("docs/changes.md", &devc::diff::reference());
}
