//! Files written whole or not at all.

#[cfg(unix)]
use std::os::unix::fs::{MetadataExt, OpenOptionsExt, fchown};

use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::outcome::Failure;
use super::workplace::{DRAFT, Workplace};

/// A new text for a file, under a name of its own until it is published; gone if it is not.
pub(super) struct Draft {
    path: PathBuf,
    target: PathBuf,
    published: bool,
}

impl Draft {
    /// Writes what the target is to have, with the rights and, if it can be, the owner of what is there.
    pub(super) fn write(
        place: &Workplace,
        target: &Path,
        content: impl AsRef<[u8]>,
    ) -> Result<Self, Failure> {
        let failure = |error| Failure::at("write", target, &error);
        let old = fs::symlink_metadata(target).ok();
        let (path, mut file) = create(&place.folder, old.as_ref()).map_err(failure)?;
        let draft = Self { path, target: target.to_owned(), published: false };
        file.write_all(content.as_ref()).map_err(failure)?;
        if let Some(old) = old {
            #[cfg(unix)]
            let _ = fchown(&file, Some(old.uid()), Some(old.gid()));
            file.set_permissions(old.permissions()).map_err(failure)?;
        }
        Ok(draft)
    }

    /// For a text that cannot be made again: waits until it is on the disk, and sees to it that it has its owner.
    pub(super) fn secure(&self) -> Result<(), Failure> {
        let failure = |error| Failure::at("write", &self.target, &error);
        File::options().append(true).open(&self.path).and_then(|file| file.sync_all()).map_err(failure)?;
        let owner = |path: &Path| fs::metadata(path).map(|metadata| owner(&metadata)).map_err(failure);
        if owner(&self.path)? != owner(&self.target)? {
            return Err(Failure::new(format!(
                "cannot edit `{}`: it belongs to another",
                self.target.display()
            ))
            .help("run devc as its owner"));
        }
        Ok(())
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

/// A file under the first free name; nobody may read it who may not read the old one.
fn create(folder: &Path, old: Option<&Metadata>) -> io::Result<(PathBuf, File)> {
    let mut options = File::options();
    options.write(true).create_new(true);
    #[cfg(unix)]
    options.mode(old.map_or(0o666, |old| old.mode() & 0o777));
    let process = std::process::id();
    let mut number = 0_u32;
    loop {
        let path = folder.join(format!("{DRAFT}{process}-{number}"));
        match options.open(&path) {
            // Left behind, or of a process that has the same number on another machine.
            Err(error) if error.kind() == ErrorKind::AlreadyExists && number < u32::MAX => number += 1,
            opened => return opened.map(|file| (path, file)),
        }
    }
}

#[cfg(unix)]
fn owner(metadata: &Metadata) -> (u32, u32) {
    (metadata.uid(), metadata.gid())
}

#[cfg(not(unix))]
fn owner(_: &Metadata) {}
