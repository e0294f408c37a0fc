//! Files of a description that are edited: the new text takes the place of what was read, or nothing does.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use devc::source::{Disk, Loader};

use super::draft::Draft;
use super::existing;
use super::outcome::Failure;
use super::report::Report;
use super::workplace::Workplace;

/// A file with its edits.
pub(super) struct Edited {
    /// The name under which the file was read.
    pub(super) name: PathBuf,
    pub(super) old: String,
    pub(super) new: String,
}

/// Writes all of them; if one cannot be written, none is, unless the last moment brings it about.
pub(super) fn write(files: &[Edited], report: &Report) -> Result<(), Failure> {
    let mut folders: BTreeMap<&Path, Vec<&Edited>> = BTreeMap::new();
    for file in files {
        if let Some(folder) = file.name.parent() {
            folders.entry(folder).or_default().push(file);
        }
    }
    // in the order of their names, so that no two runs wait for one another
    let places: Vec<_> =
        folders.iter().map(|(folder, files)| (Workplace::enter(folder, report), files)).collect();
    let files = || places.iter().flat_map(|(place, files)| files.iter().map(move |file| (place, file)));
    let drafts = files().map(|(place, file)| file.draft(place)).collect::<Result<Vec<_>, _>>()?;
    files().zip(drafts).try_for_each(|((_, file), draft)| file.publish(draft))
}

impl Edited {
    fn draft(&self, place: &Workplace) -> Result<Draft, Failure> {
        existing::be_writable(&self.name)?;
        be_only_name(&self.name)?;
        let draft = Draft::write(place, &self.name, &self.new)?;
        draft.secure()?;
        Ok(draft)
    }

    /// Puts the new text in the place of the old one, if that is still what was read.
    fn publish(&self, draft: Draft) -> Result<(), Failure> {
        let now = Disk.read(&self.name).map_err(|error| Failure::at("read", &self.name, &error))?;
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
