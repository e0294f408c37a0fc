//! Edits that a message is sure of, made in the files of a description.

use std::collections::BTreeMap;

use devc::Compilation;
use devc::diagnostic::Edit;
use devc::source::FileId;

use super::edited::{self, Edited};
use super::outcome::Failure;
use super::report::Report;

/// Makes the edits and says how many there were; what is not edited stays as it was to the byte.
pub(super) fn fix(compilation: &Compilation, report: &Report) -> Result<usize, Failure> {
    let mut made = 0;
    let mut files = Vec::new();
    for (file, edits) in edits(compilation) {
        // A profile has no name: it is not on the disk.
        let (Some(source), Some(name)) = (compilation.sources.get(file), compilation.sources.name(file))
        else {
            continue;
        };
        let (new, count) = edited(&source.text, edits);
        if count > 0 {
            files.push(Edited { name: name.to_owned(), old: source.text.clone(), new });
            made += count;
        }
    }
    edited::write(&files, report)?;
    Ok(made)
}

/// The first sure help of each message, by file.
fn edits(compilation: &Compilation) -> BTreeMap<FileId, Vec<&Edit>> {
    let mut edits: BTreeMap<FileId, Vec<&Edit>> = BTreeMap::new();
    for diagnostic in compilation.diagnostics.iter() {
        let sure = diagnostic.helps.iter().find(|help| help.sure);
        for edit in sure.into_iter().flat_map(|help| &help.edits) {
            edits.entry(edit.at.file).or_default().push(edit);
        }
    }
    edits
}

/// The text with the edits made from the last to the first; of two that overlap, the earlier waits for the
/// next run.
fn edited(text: &str, mut edits: Vec<&Edit>) -> (String, usize) {
    edits.sort_by_key(|edit| std::cmp::Reverse((edit.at.end, edit.at.start)));
    edits.dedup();
    let mut text = text.to_owned();
    let mut free = text.len();
    let mut made = 0;
    for edit in edits {
        let (Ok(start), Ok(end)) = (usize::try_from(edit.at.start), usize::try_from(edit.at.end)) else {
            continue;
        };
        if end <= free && start <= end && text.is_char_boundary(start) && text.is_char_boundary(end) {
            text.replace_range(start..end, &edit.text);
            free = start;
            made += 1;
        }
    }
    (text, made)
}
