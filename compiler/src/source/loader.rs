//! The only place that touches a file system.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::{Component, Path, PathBuf};

use crate::text::near::near;

/// The largest file that is read, in bytes: offsets are 32 bits wide, and no description comes near.
pub const MAX_SIZE: usize = 64 << 20;

/// Where files come from.
pub trait Loader {
    /// The bytes of a file, at most one more than [`MAX_SIZE`].
    ///
    /// # Errors
    /// If there is no such file, or it cannot be read, or it is not a regular file.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// The one name of a file or folder, with links followed.
    ///
    /// # Errors
    /// If there is neither a file nor a folder.
    fn canonical(&self, path: &Path) -> io::Result<PathBuf>;

    /// The names of what lies in a folder, sorted.
    ///
    /// # Errors
    /// If it is not a folder, or it cannot be read.
    fn list(&self, folder: &Path) -> io::Result<Vec<String>>;
}

/// The file system of the machine.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

impl Loader for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let kind = fs::metadata(path)?;
        if kind.is_dir() {
            return Err(ErrorKind::IsADirectory.into());
        }
        if !kind.is_file() {
            return Err(io::Error::new(ErrorKind::InvalidInput, "is not a regular file"));
        }
        let mut bytes = Vec::new();
        File::open(path)?.take(MAX_SIZE as u64 + 1).read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        fs::canonicalize(path)
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        let mut names = fs::read_dir(folder)?
            .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
            .collect::<io::Result<Vec<_>>>()?;
        names.sort();
        Ok(names)
    }
}

/// Files that exist only in memory.
#[derive(Debug, Clone, Default)]
pub struct Memory {
    files: BTreeMap<PathBuf, Vec<u8>>,
}

impl Memory {
    /// No files.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file, or replaces the one of this name.
    #[must_use]
    pub fn with(mut self, path: impl AsRef<Path>, bytes: impl Into<Vec<u8>>) -> Self {
        self.files.insert(clean(path.as_ref()), bytes.into());
        self
    }

    fn is_folder(&self, path: &Path) -> bool {
        self.files.keys().any(|file| file != path && file.starts_with(path))
    }
}

impl Loader for Memory {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let path = clean(path);
        match self.files.get(&path) {
            Some(bytes) => Ok(bytes.get(..=MAX_SIZE).unwrap_or(bytes).to_vec()),
            None if self.is_folder(&path) => Err(ErrorKind::IsADirectory.into()),
            None => Err(ErrorKind::NotFound.into()),
        }
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        let path = clean(path);
        if self.files.contains_key(&path) || self.is_folder(&path) {
            return Ok(path);
        }
        Err(ErrorKind::NotFound.into())
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        let folder = self.canonical(folder)?;
        let mut names: Vec<String> = self
            .files
            .keys()
            .filter_map(|file| file.strip_prefix(&folder).ok()?.components().next())
            .map(|name| name.as_os_str().to_string_lossy().into_owned())
            .collect();
        names.dedup();
        Ok(names)
    }
}

/// The path without `.`, and without `..` where there is a folder to leave.
pub(super) fn clean(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(out.components().next_back(), Some(Component::Normal(_))) => {
                out.pop();
            }
            other => out.push(other),
        }
    }
    out
}

/// A name in a folder that looks like the one that is not there.
pub(super) fn similar(loader: &dyn Loader, folder: &Path, name: &str) -> Option<String> {
    let names = loader.list(folder).ok()?;
    near(name, names.iter().map(String::as_str)).map(str::to_owned)
}

/// A path as people see it on every machine.
pub(super) fn shown(path: &Path) -> String {
    let clean = clean(path);
    let text = clean.to_string_lossy().replace('\\', "/");
    if text.is_empty() { ".".to_owned() } else { text }
}
