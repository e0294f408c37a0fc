//! The texts of a compilation, the places in them, and names that look alike.
//!
//! This is the lowest room of the house: messages point into texts, and to read a description is to make messages.

pub mod characters;
pub mod files;
mod lines;
pub(crate) mod near;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

pub(crate) use lines::{Lines, Position};

/// A file of one compilation, by its place in [`Sources`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FileId(pub u32);

/// A range of bytes in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Location {
    /// The file.
    pub file: FileId,
    /// The first byte.
    pub start: u32,
    /// The byte after the last one.
    pub end: u32,
}

/// One file as it was read.
#[derive(Debug, Clone)]
pub struct SourceFile {
    /// The path as shown to people: relative where it can be, with `/` between folders.
    pub path: String,
    /// The whole text.
    pub text: String,
    /// Whether the file is one of devc's own profiles and not on the user's disk.
    pub embedded: bool,
}

/// All files of one compilation, in the order in which they were read.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    files: Vec<(SourceFile, OnceLock<Lines>)>,
    names: BTreeMap<FileId, PathBuf>,
}

impl Sources {
    /// Keeps a file and names it.
    pub fn add(&mut self, file: SourceFile) -> FileId {
        let id = FileId(u32::try_from(self.files.len()).unwrap_or(u32::MAX));
        self.files.push((file, OnceLock::new()));
        id
    }

    /// Keeps a file that was read under this name, its one name with links followed.
    pub fn add_read(&mut self, file: SourceFile, name: PathBuf) -> FileId {
        let id = self.add(file);
        self.names.insert(id, name);
        id
    }

    /// The name under which a file was read and can be found again: what is shown may stand for another one.
    pub fn name(&self, id: FileId) -> Option<&Path> {
        self.names.get(&id).map(PathBuf::as_path)
    }

    /// The file of this name, if it is one of ours.
    pub fn get(&self, id: FileId) -> Option<&SourceFile> {
        self.entry(id).map(|(file, _)| file)
    }

    /// A file with its lines.
    pub(crate) fn lines(&self, id: FileId) -> Option<(&SourceFile, &Lines)> {
        self.entry(id).map(|(file, lines)| (file, lines.get_or_init(|| Lines::of(&file.text))))
    }

    fn entry(&self, id: FileId) -> Option<&(SourceFile, OnceLock<Lines>)> {
        self.files.get(usize::try_from(id.0).ok()?)
    }

    /// What stands at a place.
    pub fn slice(&self, at: Location) -> Option<&str> {
        self.get(at.file)?.text.get(usize::try_from(at.start).ok()?..usize::try_from(at.end).ok()?)
    }

    /// All files, in the order in which they were read.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &SourceFile)> {
        (0..).map(FileId).zip(self.files.iter().map(|(file, _)| file))
    }
}
