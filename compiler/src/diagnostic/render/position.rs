//! Lines and columns.

use std::collections::BTreeMap;

#[cfg(feature = "diff")]
use crate::text::SourceFile;
use crate::text::{FileId, Location, Sources};

/// Where the lines of files start, found once for each file.
pub(crate) struct Positions<'s> {
    sources: &'s Sources,
    starts: BTreeMap<FileId, Vec<usize>>,
}

/// A place that a person can find: both numbers count from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Position {
    pub(crate) line: usize,
    /// In characters of Unicode.
    pub(crate) column: usize,
    /// In units of UTF-16, as editors count.
    pub(crate) column_utf16: usize,
}

impl<'s> Positions<'s> {
    pub(crate) fn new(sources: &'s Sources) -> Self {
        let starts = sources.iter().map(|(id, file)| {
            let breaks = file.text.match_indices('\n').map(|(place, _)| place + 1);
            (id, std::iter::once(0).chain(breaks).collect())
        });
        Self { sources, starts: starts.collect() }
    }

    /// The first and the last place of a range.
    pub(crate) fn range(&self, at: Location) -> (Position, Position) {
        (self.place(at.file, at.start), self.place(at.file, at.end))
    }

    /// A file.
    #[cfg(feature = "diff")]
    pub(crate) fn file(&self, file: FileId) -> Option<&'s SourceFile> {
        self.sources.get(file)
    }

    fn place(&self, file: FileId, offset: u32) -> Position {
        let text = self.sources.get(file).map_or("", |file| file.text.as_str());
        let mut offset = usize::try_from(offset).unwrap_or(usize::MAX).min(text.len());
        while !text.is_char_boundary(offset) {
            offset -= 1;
        }
        let starts = self.starts.get(&file).map_or(&[][..], |starts| starts);
        let line = starts.partition_point(|start| *start <= offset).max(1);
        let start = starts.get(line - 1).copied().unwrap_or(0);
        let before = text.get(start..offset).unwrap_or("");
        Position { line, column: before.chars().count() + 1, column_utf16: before.encode_utf16().count() + 1 }
    }
}
