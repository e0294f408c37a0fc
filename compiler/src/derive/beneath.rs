//! Paths from a folder, so that messages need not show where on the machine it is.

use std::io;
use std::path::{Path, PathBuf};

use crate::source::{Loader, Opened};

/// The files of a loader as seen from a folder.
pub(crate) struct Beneath<'a> {
    pub(crate) root: &'a Path,
    pub(crate) loader: &'a dyn Loader,
}

impl Loader for Beneath<'_> {
    fn read(&self, path: &Path) -> io::Result<Opened> {
        self.loader.read(&self.root.join(path))
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        self.loader.canonical(&self.root.join(path))
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        self.loader.list(&self.root.join(folder))
    }
}
