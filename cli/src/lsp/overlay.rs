//! Files as they are in the editor, and else as they are on the disk.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use devc::source::{Disk, Loader, Opened};

/// The texts that are open, by the one name of their file.
#[derive(Debug, Clone, Default)]
pub(super) struct Overlay(pub(super) BTreeMap<PathBuf, Arc<str>>);

impl Loader for Overlay {
    fn read(&self, path: &Path) -> io::Result<Opened> {
        let name = self.canonical(path)?;
        match self.0.get(&name) {
            Some(text) => Ok(Opened { name, bytes: text.as_bytes().to_vec() }),
            None => Disk.read(path),
        }
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        match Disk.canonical(path) {
            Err(_) if self.0.contains_key(path) => Ok(path.to_owned()),
            found => found,
        }
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        Disk.list(folder)
    }
}
