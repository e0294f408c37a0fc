//! The only place that touches a file system.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Component, MAIN_SEPARATOR_STR, Path, PathBuf};

use super::plain;
use crate::text::near::near;

/// The largest file that is read, in bytes: offsets are 32 bits wide, and no description comes near.
pub const MAX_SIZE: usize = 64 << 20;

/// How often a file is opened again because another was put in its place meanwhile, as editors do.
const MAX_TRIES: usize = 8;

/// A file as it was opened and read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Opened {
    /// Its one name, with links followed: of what was opened, whatever lies there now.
    pub name: PathBuf,
    /// At most one byte more than [`MAX_SIZE`].
    pub bytes: Vec<u8>,
}

/// Where files come from.
pub trait Loader {
    /// Opens a file and reads it.
    ///
    /// # Errors
    /// If there is no such file, or it cannot be read, or it is a folder, a pipe or a device.
    fn read(&self, path: &Path) -> io::Result<Opened>;

    /// The one name of a file or folder, with links followed.
    ///
    /// # Errors
    /// If there is neither a file nor a folder.
    fn canonical(&self, path: &Path) -> io::Result<PathBuf>;

    /// The names of what lies in a folder, sorted; those that are text.
    ///
    /// # Errors
    /// If it is not a folder, or it cannot be read.
    fn list(&self, folder: &Path) -> io::Result<Vec<String>>;
}

/// The file system of the machine.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

impl Loader for Disk {
    fn read(&self, path: &Path) -> io::Result<Opened> {
        for _ in 0..MAX_TRIES {
            let file = plain::open(path)?;
            if let Some(name) = plain::name(&file, path)? {
                return Ok(Opened { name, bytes: plain::content(&file, MAX_SIZE as u64 + 1)? });
            }
        }
        Err(io::Error::new(ErrorKind::InvalidInput, "it is replaced all the time"))
    }

    fn canonical(&self, path: &Path) -> io::Result<PathBuf> {
        fs::canonicalize(path)
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        let mut names = fs::read_dir(folder)?
            .filter_map(|entry| entry.map(|entry| entry.file_name().into_string().ok()).transpose())
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
    fn read(&self, path: &Path) -> io::Result<Opened> {
        let name = clean(path);
        match self.files.get(&name) {
            Some(bytes) => Ok(Opened { name, bytes: bytes.get(..=MAX_SIZE).unwrap_or(bytes).to_vec() }),
            None if self.is_folder(&name) => Err(ErrorKind::IsADirectory.into()),
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

/// The name beside a file that is not there which looks like its own.
pub(super) fn similar(loader: &dyn Loader, path: &Path) -> Option<String> {
    let names = loader.list(or_here(path.parent()?)).ok()?;
    near(&path.file_name()?.to_string_lossy(), names.iter().map(String::as_str)).map(str::to_owned)
}

/// The folder that an empty path stands for.
pub(crate) fn or_here(folder: &Path) -> &Path {
    if folder.as_os_str().is_empty() { Path::new(".") } else { folder }
}

/// A path as people see it on every machine; `..` stays, because it leads out of where a link leads.
pub(super) fn shown(path: &Path) -> String {
    let parts: PathBuf = path.components().filter(|part| *part != Component::CurDir).collect();
    let text = parts.to_string_lossy().replace(MAIN_SEPARATOR_STR, "/");
    if text.is_empty() { ".".to_owned() } else { text }
}
