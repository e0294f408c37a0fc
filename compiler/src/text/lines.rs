//! Lines and columns of a text, found once.

/// How many bytes apart the places are at which characters are counted in advance.
const STEP: usize = 1 << 10;

/// Where the lines of a text start, and how many characters there are up to places in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Lines {
    starts: Vec<usize>,
    /// The characters and the units of UTF-16 before each step.
    before: Vec<(usize, usize)>,
}

/// A place that a person can find: all numbers count from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Position {
    pub(crate) line: usize,
    /// In characters of Unicode.
    pub(crate) column: usize,
    /// In units of UTF-16, as editors count.
    pub(crate) column_utf16: usize,
}

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        let breaks = text.match_indices('\n').map(|(place, _)| place + 1);
        let mut before = Vec::with_capacity(text.len() / STEP + 1);
        let (mut characters, mut units) = (0, 0);
        for (place, byte) in text.bytes().enumerate() {
            if place.is_multiple_of(STEP) {
                before.push((characters, units));
            }
            characters += usize::from(byte & 0xC0 != 0x80);
            units += usize::from(byte & 0xC0 != 0x80) + usize::from(byte >= 0xF0);
        }
        before.push((characters, units));
        Self { starts: std::iter::once(0).chain(breaks).collect(), before }
    }

    /// Where the line of a byte starts.
    pub(crate) fn start(&self, offset: usize) -> usize {
        self.starts.get(self.line(offset) - 1).copied().unwrap_or_default()
    }

    /// Where the line of a byte ends, before its line feed.
    pub(crate) fn end(&self, offset: usize, text: &str) -> usize {
        self.starts.get(self.line(offset)).map_or(text.len(), |next| next - 1)
    }

    /// The number of the line of a byte.
    pub(crate) fn line(&self, offset: usize) -> usize {
        self.starts.partition_point(|start| *start <= offset).max(1)
    }

    /// The place of a byte in its text.
    pub(crate) fn position(&self, offset: usize, text: &str) -> Position {
        let start = self.count(self.start(offset), text);
        let end = self.count(offset, text);
        Position { line: self.line(offset), column: end.0 - start.0 + 1, column_utf16: end.1 - start.1 + 1 }
    }

    /// How many characters and units of UTF-16 there are before a byte.
    fn count(&self, offset: usize, text: &str) -> (usize, usize) {
        let step = offset / STEP;
        let (characters, units) = self.before.get(step).copied().unwrap_or_default();
        let rest = text.as_bytes().get(step * STEP..offset).unwrap_or_default();
        let more = rest.iter().filter(|byte| **byte & 0xC0 != 0x80).count();
        (characters + more, units + more + rest.iter().filter(|byte| **byte >= 0xF0).count())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_those_that_counting_finds() {
        let line = "ä𝛉 = 'x' # é\r\n";
        let text = line.repeat(400) + "no line feed";
        let lines = Lines::of(&text);
        let boundaries = (0..=text.len()).filter(|at| text.is_char_boundary(*at));
        for at in boundaries {
            let before = &text[..at];
            let start = before.rfind('\n').map_or(0, |feed| feed + 1);
            let expected = Position {
                line: before.matches('\n').count() + 1,
                column: before[start..].chars().count() + 1,
                column_utf16: before[start..].encode_utf16().count() + 1,
            };
            assert_eq!(lines.position(at, &text), expected, "byte {at}");
            assert_eq!(lines.start(at), start);
            assert_eq!(lines.end(at, &text), text[at..].find('\n').map_or(text.len(), |feed| at + feed));
        }
    }
}
