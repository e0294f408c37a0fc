//! Lines and columns of places.

use crate::text::{Location, Position, Sources};

/// The first and the last place of a range.
pub(crate) fn range(at: Location, sources: &Sources) -> (Position, Position) {
    (place(at, at.start, sources), place(at, at.end, sources))
}

fn place(at: Location, offset: u32, sources: &Sources) -> Position {
    let Some((file, lines)) = sources.lines(at.file) else {
        return Position { line: 1, column: 1, column_utf16: 1 };
    };
    let mut offset = usize::try_from(offset).unwrap_or(usize::MAX).min(file.text.len());
    while !file.text.is_char_boundary(offset) {
        offset -= 1;
    }
    lines.position(offset, &file.text)
}
