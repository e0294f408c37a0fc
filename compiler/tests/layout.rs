//! What is shipped is laid out as `devc fmt` does it. That a layout changes how a description is written, and never what it
//! says, is asked in `fuzz/`.

#![allow(clippy::expect_used)] // a test may
#![cfg(feature = "cli")]

use std::fs;
use std::path::{Path, PathBuf};

use devc::format::format;

/// The TOML files in a folder.
fn toml_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    entries.filter(|path| path.extension().is_some_and(|extension| extension == "toml")).collect()
}

#[test]
fn what_is_shipped_is_laid_out() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let profiles = toml_files(&root.join("compiler/profiles"));
    assert_eq!(profiles.len(), 2);
    let devices = fs::read_dir(root.join("devices")).expect("a folder");
    let devices = devices.flat_map(|entry| toml_files(&entry.expect("an entry").path()));
    for file in devices.chain(profiles) {
        let (name, text) = (file.display().to_string(), fs::read_to_string(&file).expect("a text"));
        let new = format(&name, &text).expect("TOML");
        assert!(new == text, "{name} is not laid out: run `devc fmt`");
    }
}
