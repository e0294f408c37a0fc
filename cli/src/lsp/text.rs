//! Places of a text as editors count them: lines from 0, and columns in units of UTF-16.

use std::ops::Range;
use std::sync::Arc;

use lsp_types::{Position, TextDocumentContentChangeEvent};

/// A text with the starts of its lines.
#[derive(Debug, Clone)]
pub(super) struct Text {
    pub(super) text: Arc<str>,
    starts: Vec<usize>,
}

impl Text {
    pub(super) fn new(text: impl Into<Arc<str>>) -> Self {
        let text = text.into();
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        Self { text, starts }
    }

    /// The place of a byte.
    pub(super) fn position(&self, offset: usize) -> Position {
        let line = self.starts.partition_point(|start| *start <= offset).saturating_sub(1);
        let start = self.starts.get(line).copied().unwrap_or_default();
        let units = self.text.get(start..offset).map_or(0, |before| before.encode_utf16().count());
        Position {
            line: u32::try_from(line).unwrap_or(u32::MAX),
            character: u32::try_from(units).unwrap_or(u32::MAX),
        }
    }

    pub(super) fn range(&self, at: &Range<usize>) -> lsp_types::Range {
        lsp_types::Range { start: self.position(at.start), end: self.position(at.end) }
    }

    /// The byte at a place; the end of its line, or of the text, for one beyond it.
    pub(super) fn offset(&self, position: Position) -> usize {
        let line = usize::try_from(position.line).unwrap_or(usize::MAX);
        let Some(start) = self.starts.get(line).copied() else { return self.text.len() };
        let end = self.starts.get(line.saturating_add(1)).map_or(self.text.len(), |next| next - 1);
        let mut units = usize::try_from(position.character).unwrap_or(usize::MAX);
        for (place, c) in self.text.get(start..end).unwrap_or_default().char_indices() {
            if units < c.len_utf16() {
                return start + place;
            }
            units -= c.len_utf16();
        }
        end
    }

    /// The text after a change.
    pub(super) fn changed(&self, change: TextDocumentContentChangeEvent) -> Self {
        let Some(range) = change.range else { return Self::new(change.text) };
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        let (before, behind) = (self.text.get(..start), self.text.get(start.max(end)..));
        Self::new([before.unwrap_or_default(), &change.text, behind.unwrap_or_default()].concat())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_units_of_utf_16() {
        let text = Text::new("aä𝛉b\r\nc\n");
        for (offset, line, character) in
            [(0, 0, 0), (1, 0, 1), (3, 0, 2), (7, 0, 4), (8, 0, 5), (10, 1, 0), (12, 2, 0)]
        {
            assert_eq!(text.position(offset), Position { line, character }, "byte {offset}");
            assert_eq!(text.offset(Position { line, character }), offset);
        }
        assert_eq!(text.offset(Position { line: 0, character: 3 }), 3, "within a character");
        assert_eq!(text.offset(Position { line: 1, character: 99 }), 11, "behind the end of a line");
        assert_eq!(text.offset(Position { line: 9, character: 0 }), 12, "behind the end");
    }
}
