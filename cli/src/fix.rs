//! Edits that a message is sure of, made in the files of a description.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use devc::Compilation;
use devc::diagnostic::Edit;
use devc::source::{Disk, FileId, Loader};

use super::draft::Draft;
use super::existing;
use super::outcome::Failure;
use super::report::Report;
use super::workplace::Workplace;

/// A file with its edits.
struct Edited<'a> {
    /// The name under which the file was read.
    name: &'a Path,
    old: &'a str,
    new: String,
}

/// Makes the edits and says how many there were; what is not edited stays as it was to the byte.
pub(super) fn fix(compilation: &Compilation, report: &Report) -> Result<usize, Failure> {
    let mut made = 0;
    let mut folders: BTreeMap<&Path, Vec<Edited<'_>>> = BTreeMap::new();
    for (file, edits) in edits(compilation) {
        // A profile has no name: it is not on the disk.
        let (Some(source), Some(name)) = (compilation.sources.get(file), compilation.sources.name(file))
        else {
            continue;
        };
        let (new, count) = edited(&source.text, edits);
        if let Some(folder) = name.parent().filter(|_| count > 0) {
            folders.entry(folder).or_default().push(Edited { name, old: &source.text, new });
            made += count;
        }
    }
    // in the order of their names, so that no two runs wait for one another
    let places: Vec<_> =
        folders.iter().map(|(folder, files)| (Workplace::enter(folder, report), files)).collect();
    let files = || places.iter().flat_map(|(place, files)| files.iter().map(move |file| (place, file)));
    let drafts = files().map(|(place, file)| file.draft(place)).collect::<Result<Vec<_>, _>>()?;
    files().zip(drafts).try_for_each(|((_, file), draft)| file.publish(draft))?;
    Ok(made)
}

impl Edited<'_> {
    fn draft(&self, place: &Workplace) -> Result<Draft, Failure> {
        existing::be_writable(self.name)?;
        be_only_name(self.name)?;
        let draft = Draft::write(place, self.name, &self.new)?;
        draft.secure()?;
        Ok(draft)
    }

    /// Puts the new text in the place of the old one, if that is still what was read.
    fn publish(&self, draft: Draft) -> Result<(), Failure> {
        let now = Disk.read(self.name).map_err(|error| Failure::at("read", self.name, &error))?;
        if now.name != self.name || now.bytes != self.old.as_bytes() {
            let what = format!("`{}` was changed while devc looked at it", self.name.display());
            return Err(Failure::new(what).help("save it and run devc again"));
        }
        draft.publish()
    }
}

/// That the file has one name: under another it would keep the old text, unless it were written over in place, and
/// then a full disk could leave half of it.
#[cfg(unix)]
fn be_only_name(file: &Path) -> Result<(), Failure> {
    use std::os::unix::fs::MetadataExt;

    match fs::symlink_metadata(file) {
        Ok(metadata) if metadata.nlink() > 1 => {
            let what = format!("cannot edit `{}`: it has another name, by a hard link", file.display());
            Err(Failure::new(what).help("edit it by hand, or copy it so that it is a file of its own"))
        }
        _ => Ok(()),
    }
}

#[cfg(not(unix))]
fn be_only_name(_: &Path) -> Result<(), Failure> {
    Ok(())
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
