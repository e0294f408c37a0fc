//! What is shown of a file: the lines around some places, not all of it, since a message should not cost more in a
//! large file than in a small one.

use std::ops::Range;

use crate::text::{FileId, Lines, Location, Position, SourceFile, Sources};

/// How many bytes of lines a place may lie in to be shown.
const LONGEST: usize = 4 << 10;

/// How many bytes apart places may be to be shown as one.
const GAP: usize = 16 << 10;

/// Some of the places, as they are shown.
pub(super) enum Shown<'a> {
    Window(Window<'a>),
    /// A place in lines that are too long to be shown.
    Place {
        number: usize,
        path: &'a str,
        position: Position,
    },
}

/// Whole lines of a file.
pub(super) struct Window<'a> {
    pub(super) path: &'a str,
    pub(super) text: &'a str,
    /// The number of the first line.
    pub(super) line: usize,
    /// The places in it: the number of each, and its bytes in the text.
    pub(super) places: Vec<(usize, Range<usize>)>,
}

/// Places with the lines around all of them.
struct Group {
    file: FileId,
    lines: Range<usize>,
    places: Vec<(usize, Range<usize>)>,
}

impl Group {
    /// Whether it is one place in a line that is too long to be shown.
    fn is_long(&self) -> bool {
        self.places.len() == 1 && self.lines.len() > LONGEST
    }

    fn is_near(&self, file: FileId, lines: &Range<usize>) -> bool {
        let near = self.lines.start.saturating_sub(GAP)..self.lines.end.saturating_add(GAP);
        self.file == file && lines.start <= near.end && near.start <= lines.end
    }

    fn add(&mut self, number: usize, place: Range<usize>, lines: &Range<usize>) {
        self.lines = self.lines.start.min(lines.start)..self.lines.end.max(lines.end);
        self.places.push((number, place));
    }

    fn shown(self, sources: &Sources) -> Option<Shown<'_>> {
        let (file, lines) = sources.lines(self.file)?;
        if self.is_long() {
            let (number, place) = self.places.into_iter().next()?;
            let position = lines.position(place.start, &file.text);
            return Some(Shown::Place { number, path: &file.path, position });
        }
        let start = self.lines.start;
        let relative =
            |(number, place): (usize, Range<usize>)| (number, place.start - start..place.end - start);
        Some(Shown::Window(Window {
            path: &file.path,
            text: file.text.get(self.lines)?,
            line: lines.line(start),
            places: self.places.into_iter().map(relative).collect(),
        }))
    }
}

/// What is shown for some places, in their order; those of a file that are near each other stand in one window.
pub(super) fn windows(places: impl Iterator<Item = Location>, sources: &Sources) -> Vec<Shown<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for (number, at) in places.enumerate() {
        let Some((file, lines)) = sources.lines(at.file) else { continue };
        let (place, around) = around(at, file, lines);
        let short = around.len() <= LONGEST;
        let near =
            groups.iter_mut().find(|group| short && !group.is_long() && group.is_near(at.file, &around));
        match near {
            Some(group) => group.add(number, place, &around),
            None => groups.push(Group { file: at.file, lines: around, places: vec![(number, place)] }),
        }
    }
    groups.into_iter().filter_map(|group| group.shown(sources)).collect()
}

/// The bytes of a place and the lines that it lies in: its first, if all are too many.
fn around(at: Location, file: &SourceFile, lines: &Lines) -> (Range<usize>, Range<usize>) {
    let place = range(at, &file.text);
    let whole = lines.start(place.start)..lines.end(place.end, &file.text);
    if whole.len() <= LONGEST {
        return (place, whole);
    }
    let first = whole.start..lines.end(place.start, &file.text);
    (place.start..place.end.min(first.end), first)
}

/// The length of the lines that a place covers, in bytes.
pub(super) fn line_length(at: Location, file: &SourceFile, lines: &Lines) -> usize {
    let place = range(at, &file.text);
    lines.end(place.end, &file.text) - lines.start(place.start)
}

/// The bytes of a place, moved to where characters begin so that no text can be cut in one.
fn range(at: Location, text: &str) -> Range<usize> {
    let floor = |offset: u32| {
        let offset = usize::try_from(offset).unwrap_or(usize::MAX).min(text.len());
        (0..=offset).rev().find(|offset| text.is_char_boundary(*offset)).unwrap_or(0)
    };
    let start = floor(at.start);
    start..floor(at.end).max(start)
}
