//! The lines of a document: groups stay on one if they fit.

use super::document::{Document, Group, Kind, Mark};

/// Columns of a line.
pub(super) const WIDTH: usize = 110;

/// Columns by which what is inside stands further to the right.
const INDENT: usize = 4;

/// The document as lines, each with its end.
pub(super) fn lines(document: &Document) -> String {
    let mut lines = Lines {
        text: &document.text,
        marks: &document.marks,
        at: 0,
        column: 0,
        out: String::with_capacity(document.text.len().saturating_mul(5) / 4),
    };
    lines.items(0, document.marks.len(), 0);
    lines.copy(document.text.len());
    lines.out.push('\n');
    lines.out
}

struct Lines<'a> {
    text: &'a str,
    marks: &'a [Mark],
    /// How far the text is written.
    at: usize,
    /// Columns of the line so far.
    column: usize,
    out: String,
}

impl Lines<'_> {
    /// Writes the items up to the mark `end`, each on lines of its own.
    fn items(&mut self, first: usize, end: usize, indent: usize) {
        let mut number = first;
        loop {
            number = self.item(number, end, indent);
            let Some(mark) = self.marks.get(number).filter(|_| number < end) else { return };
            self.copy(mark.at);
            if matches!(mark.kind, Kind::Between { is_apart: true }) {
                self.out.push('\n');
            }
            self.newline(mark, indent);
            number += 1;
        }
    }

    /// Writes an item of the group that ends at the mark `end`, and gives the number of the mark behind the item.
    fn item(&mut self, first: usize, end: usize, indent: usize) -> usize {
        let (mut number, mut is_block_broken) = (first, false);
        while let Some(mark) = self.marks.get(number).filter(|_| number < end) {
            match mark.kind {
                Kind::Between { .. } => break,
                Kind::Close { .. } => {}
                Kind::Line => {
                    self.copy(mark.at);
                    self.newline(mark, indent);
                }
                Kind::Soft => {
                    self.copy(mark.at);
                    if !self.fits(self.reach(number + 1, end)) {
                        self.newline(mark, indent + INDENT);
                    }
                }
                Kind::Open { group, end: close, is_tall } => {
                    self.copy(mark.at);
                    let reach = match group {
                        Group::Block => self.rest(close + 1, end),
                        _ => self.reach(close + 1, end),
                    };
                    let is_flat = !is_tall && self.fits(reach) && !(group == Group::Block && is_block_broken);
                    if !is_flat {
                        is_block_broken |= group == Group::Block;
                        self.group(number, close, reach, indent);
                    }
                    number = close;
                }
            }
            number += 1;
        }
        number
    }

    /// Writes a group that does not fit on the line; what has to stand behind it reaches to `reach`.
    fn group(&mut self, open: usize, close: usize, reach: usize, indent: usize) {
        let (Some(mark), Some(last)) = (self.marks.get(open), self.marks.get(close)) else { return };
        let Kind::Open { group, .. } = mark.kind else { return };
        let (first, inner) = (open + 1, indent + INDENT);
        if let Some((wrapped, begins)) = self.wrapped(open, close) {
            self.copy(begins);
            self.group(wrapped, close - 1, reach, indent);
            return;
        }
        match group {
            Group::Value => return self.value(open, close, reach, indent),
            Group::Words { .. } => {
                self.newline(mark, inner);
                self.words(first, close, inner);
            }
            Group::List { .. } | Group::Generics { .. } | Group::Block => {
                self.newline(mark, inner);
                self.items(first, close, inner);
            }
        }
        self.copy(last.at);
        if comma(last) > 0 {
            self.out.push(',');
        }
        self.newline(last, indent);
    }

    /// Writes a value on the next line if it fits there, else where it is, with its groups broken.
    fn value(&mut self, open: usize, close: usize, reach: usize, indent: usize) {
        let Some(mark) = self.marks.get(open) else { return };
        let Kind::Open { is_tall, .. } = mark.kind else { return };
        let below = indent + INDENT;
        let fits_below = !is_tall && below + self.width(mark.at + mark.skip, reach) <= WIDTH;
        let begins_here = self.fits(self.reach(open + 1, close));
        if fits_below {
            self.newline(mark, below);
        } else if begins_here {
            self.item(open + 1, close, indent);
        } else {
            self.newline(mark, below);
            self.item(open + 1, close, below);
        }
    }

    /// The group that is broken in the place of a list, and the byte where it begins: all that the list holds, or
    /// the block of a closure at its end.
    fn wrapped(&self, open: usize, close: usize) -> Option<(usize, usize)> {
        let (list, last, end) = (self.marks.get(open)?, self.marks.get(close)?, self.marks.get(close - 1)?);
        let Kind::Open { group: Group::List { .. }, .. } = list.kind else { return None };
        let Kind::Close { open: inner, .. } = end.kind else { return None };
        let (begin, before) = (self.marks.get(inner)?, self.marks.get(open + 1..inner)?);
        // a list in braces is the body of something; behind what is wrapped is but its own bracket
        let is_wrapped = list.skip == 0 && end.at + end.skip + 1 == last.at;
        let is_block = self.text.get(..begin.at).is_some_and(|text| text.ends_with("| {"));
        let is_flat = |mark: &Mark| !matches!(mark.kind, Kind::Line | Kind::Open { is_tall: true, .. });
        let is_alone = before.is_empty() || is_block && before.iter().all(is_flat) && self.fits(begin.at);
        (is_wrapped && is_alone).then_some((inner, begin.at))
    }

    /// Writes the words of a group, as many a line as fit.
    fn words(&mut self, first: usize, close: usize, indent: usize) {
        for number in first..=close {
            let Some(mark) = self.marks.get(number) else { return };
            let width = self.width(self.at, mark.at) + 1;
            if self.column > indent && self.column + 1 + width > WIDTH {
                let start = Mark { at: self.at, skip: 0, kind: Kind::Soft };
                self.newline(&start, indent);
            } else if self.column > indent {
                self.out.push(' ');
                self.column += 1;
            }
            self.copy(mark.at);
            self.at = if number == close { mark.at } else { mark.at + mark.skip };
        }
    }

    /// How far the text goes that stands on one line whatever is broken behind the mark.
    fn reach(&self, mut number: usize, end: usize) -> usize {
        while let Some(mark) = self.marks.get(number) {
            number = match mark.kind {
                Kind::Open { group: Group::Generics { .. }, end, .. } => end,
                Kind::Close { .. } if number != end => number,
                _ => return mark.at + comma(mark),
            } + 1;
        }
        self.text.len()
    }

    /// How far the item goes, on one line.
    fn rest(&self, mut number: usize, end: usize) -> usize {
        while let Some(mark) = self.marks.get(number) {
            number = match mark.kind {
                Kind::Open { end, .. } => end,
                Kind::Between { .. } | Kind::Line => return mark.at,
                Kind::Close { .. } if number == end => return mark.at + comma(mark),
                Kind::Close { .. } | Kind::Soft => number,
            } + 1;
        }
        self.text.len()
    }

    fn fits(&self, reach: usize) -> bool {
        self.column + self.width(self.at, reach) <= WIDTH
    }

    /// The columns of a part of the text; too many for a line if it is long.
    fn width(&self, from: usize, to: usize) -> usize {
        match self.text.get(from..to) {
            Some(part) if part.len() <= WIDTH * 4 => part.chars().count(),
            _ => WIDTH * 4,
        }
    }

    /// Writes the text up to a byte as it is.
    fn copy(&mut self, to: usize) {
        self.column += self.width(self.at, to);
        self.out.push_str(self.text.get(self.at..to).unwrap_or_default());
        self.at = to;
    }

    /// Ends the line at a mark up to which the text is written.
    fn newline(&mut self, mark: &Mark, indent: usize) {
        self.at = mark.at + mark.skip;
        self.column = indent;
        self.out.truncate(self.out.trim_end_matches(' ').len());
        self.out.push('\n');
        self.out.extend(std::iter::repeat_n(' ', indent));
    }
}

/// The columns of the comma that stands before the mark if the group that it ends is broken.
fn comma(mark: &Mark) -> usize {
    usize::from(matches!(mark.kind, Kind::Close { comma: true, .. }))
}
