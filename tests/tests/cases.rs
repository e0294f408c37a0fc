//! Bad descriptions and what devc says of them: a folder a case.
//!
//! `cases/<name>/` holds a description and `messages.txt`, all that is reported about it. A new folder is a new
//! case; `cargo accept` writes its messages.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

use std::fs;
use std::path::{Path, PathBuf};

use devc::diagnostic::render::{Style, text};
use devc::source::Disk;

/// The folders of all cases, by name.
fn cases() -> Vec<PathBuf> {
    let entries = fs::read_dir("cases").expect("the tests run in their package");
    let mut folders: Vec<_> = entries.map(|entry| entry.expect("a case").path()).collect();
    folders.sort();
    folders
}

/// All that devc says about a description, one message after the other.
fn messages(folder: &Path) -> String {
    let compilation = devc::compile(&Disk, folder);
    let messages = compilation.diagnostics.iter().map(|diagnostic| {
        let text = text(diagnostic, &compilation.sources, Style::Plain);
        text.lines().map(|line| format!("{}\n", line.trim_end())).collect::<String>()
    });
    messages.collect::<Vec<_>>().join("\n")
}

#[test]
fn bad_descriptions_get_their_messages() {
    let bless = std::env::var_os("DEVC_BLESS").is_some();
    let mut wrong = Vec::new();
    for folder in cases() {
        let file = folder.join("messages.txt");
        let messages = messages(&folder);
        let expected = fs::read_to_string(&file).unwrap_or_default();
        if messages == expected {
            continue;
        }
        if bless {
            fs::write(&file, &messages).expect("messages can be written");
        } else {
            wrong.push(format!("{}\n--- expected\n{expected}--- found\n{messages}", file.display()));
        }
    }
    assert!(wrong.is_empty(), "{}\n`cargo accept` takes what was found", wrong.join("\n\n"));
}

#[test]
fn every_case_is_refused() {
    for folder in cases() {
        let compilation = devc::compile(&Disk, &folder);
        assert!(compilation.family.is_none(), "{} has no error", folder.display());
    }
}
