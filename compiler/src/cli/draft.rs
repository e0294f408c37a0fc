//! Files written whole or not at all.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use super::outcome::Failure;

/// The end of the name of a file that is being written.
pub(super) const TEMPORARY: &str = ".devc-tmp";

/// A new text beside the file that it is to become; gone if it does not.
pub(super) struct Draft {
    path: PathBuf,
    target: PathBuf,
    published: bool,
}

impl Draft {
    /// Writes the text that `folder/name` is to have.
    pub(super) fn write(folder: &Path, name: &str, text: &str) -> Result<Self, Failure> {
        let target = folder.join(name);
        let path = folder.join(format!(".{name}.{}{TEMPORARY}", std::process::id()));
        let file = File::options().write(true).create_new(true).open(&path);
        let mut file = file.map_err(|error| Failure::at("write", &target, &error))?;
        let draft = Self { path, target, published: false };
        file.write_all(text.as_bytes()).map_err(|error| Failure::at("write", &draft.target, &error))?;
        Ok(draft)
    }

    /// Puts the text in the place of the old one.
    pub(super) fn publish(mut self) -> Result<(), Failure> {
        fs::rename(&self.path, &self.target).map_err(|error| Failure::at("write", &self.target, &error))?;
        self.published = true;
        Ok(())
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if !self.published {
            // What cannot be removed now, the next run will remove.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Replaces the text of a file, or makes the file.
pub(super) fn replace(path: &Path, text: &str) -> Result<(), Failure> {
    // A link stays a link: what it leads to is replaced.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    Draft::write(folder, &name, text)?.publish()
}
