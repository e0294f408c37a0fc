//! Code on one line, with marks where it may or must be broken.

use std::fmt::{Display, Write};

/// Code on one line, with marks.
#[derive(Debug, Default)]
pub(super) struct Document {
    /// All of it on one line.
    pub(super) text: String,
    /// In the order of the text; a group ends before the one that it is in.
    pub(super) marks: Vec<Mark>,
    /// The groups that have no end yet.
    open: Vec<usize>,
}

/// A place in the text where a line may end.
#[derive(Debug)]
pub(super) struct Mark {
    /// The byte in the text.
    pub(super) at: usize,
    /// The bytes that a broken line leaves out: the space behind the mark, if there is one.
    pub(super) skip: usize,
    pub(super) kind: Kind,
}

#[derive(Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A group begins.
    Open {
        group: Group,
        /// The number of the mark where it ends.
        end: usize,
        /// Whether there is something in it that needs more than a line.
        is_tall: bool,
    },
    /// A group ends.
    Close {
        /// The number of the mark where it begins.
        open: usize,
        /// Whether there is a comma before the end if the group is broken.
        comma: bool,
    },
    /// Between two items of a group, with an empty line or without, if each has a line of its own.
    Between { is_apart: bool },
    /// A line ends if what follows does not fit.
    Soft,
    /// A line ends.
    Line,
}

/// How a group is laid out that does not fit on the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    /// An item a line, with a comma behind the last or without.
    List { comma: bool },
    /// An item a line too, but only if nothing else can be broken.
    Generics { comma: bool },
    /// As many items a line as fit, with a comma behind the last or without.
    Words { comma: bool },
    /// A statement a line; all the blocks of an expression alike.
    Block,
    /// On the next line, if that makes it fit.
    Value,
}

impl Document {
    /// Begins a group that may be broken here, with this much space.
    pub(super) fn open(&mut self, group: Group, space: &str) {
        self.open.push(self.marks.len());
        self.mark(Kind::Open { group, end: 0, is_tall: false }, space);
    }

    /// Ends the group that began last.
    pub(super) fn close(&mut self, space: &str) {
        let number = self.marks.len();
        let Some(open) = self.open.pop() else { return };
        let Some(Mark { kind: Kind::Open { group, end, is_tall }, .. }) = self.marks.get_mut(open) else {
            return;
        };
        *end = number;
        let comma = match *group {
            Group::Words { comma } | Group::List { comma } | Group::Generics { comma } => comma,
            Group::Block | Group::Value => false,
        };
        if *is_tall {
            self.heighten();
        }
        self.mark(Kind::Close { open, comma }, space);
    }

    /// Says that the group that began last needs more than a line.
    pub(super) fn heighten(&mut self) {
        let opened = self.open.last().and_then(|opened| self.marks.get_mut(*opened));
        if let Some(Mark { kind: Kind::Open { is_tall, .. }, .. }) = opened {
            *is_tall = true;
        }
    }

    /// Goes on to the next item of a group, and gives the number of the mark.
    pub(super) fn next_item(&mut self, space: &str) -> usize {
        let number = self.marks.len();
        self.mark(Kind::Between { is_apart: false }, space);
        number
    }

    /// Puts an empty line at the mark between two items.
    pub(super) fn set_apart(&mut self, number: usize) {
        if let Some(mark) = self.marks.get_mut(number) {
            mark.kind = Kind::Between { is_apart: true };
        }
    }

    /// Marks a place where a line may end.
    pub(super) fn soft(&mut self, space: &str) {
        self.mark(Kind::Soft, space);
    }

    /// Ends the line.
    pub(super) fn line(&mut self) {
        self.mark(Kind::Line, "");
        self.heighten();
    }

    /// Writes something as it shows itself.
    pub(super) fn write(&mut self, what: impl Display) {
        // a text takes whatever is written to it
        let _ = write!(self.text, "{what}");
    }

    fn mark(&mut self, kind: Kind, space: &str) {
        self.marks.push(Mark { at: self.text.len(), skip: space.len(), kind });
        self.text.push_str(space);
    }
}
