//! Where in a text its author is.

use super::builder::{Builder, Open};
use super::{Headed, Key, names};

/// What would be written at a place of a text.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Cursor {
    /// The keys of the tables around it, the outermost first.
    pub(crate) around: Vec<String>,
    /// What belongs there.
    pub(crate) slot: Slot,
    /// The keys that the table around it has already, as far as they stand before the place.
    pub(crate) siblings: Vec<String>,
}

/// What belongs to a place.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Slot {
    /// A key in a header, behind those in `around`.
    Header,
    /// A key of the table.
    Key,
    /// A value of this key of the table; for a list, one of its elements.
    Value(String),
    /// A comment, or a text of several lines.
    Prose,
}

impl Cursor {
    /// Looks at what stands before a byte of the text.
    pub(crate) fn at(text: &str, offset: usize) -> Self {
        let before = text.get(..offset).unwrap_or(text);
        let before = before.get(..before.len() - word(before).len()).unwrap_or(before);
        let line = before.rsplit('\n').next().unwrap_or(before);
        let builder = Builder::read(before);
        if builder.in_prose || matches!(Tail::of(line), Tail::Comment) {
            return Self { around: Vec::new(), slot: Slot::Prose, siblings: Vec::new() };
        }
        builder.cursor(line)
    }
}

/// The word that is being written at the end of a text, its first quote included.
pub(crate) fn word(before: &str) -> &str {
    let line = before.rsplit('\n').next().unwrap_or(before);
    let start = match Tail::of(line) {
        // in an open string all of it is the word
        Tail::Quote(start) => start,
        Tail::Code | Tail::Comment => {
            let is_word = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | ':');
            line.trim_end_matches(is_word).len()
        }
    };
    line.get(start..).unwrap_or_default()
}

/// What a line ends in.
#[derive(Clone, Copy)]
enum Tail {
    Code,
    /// A string that begins at this byte and is still open.
    Quote(usize),
    Comment,
}

impl Tail {
    fn of(line: &str) -> Self {
        let mut open: Option<(usize, char)> = None;
        let mut is_escaped = false;
        for (place, c) in line.char_indices() {
            match open {
                _ if is_escaped => is_escaped = false,
                Some((_, '"')) if c == '\\' => is_escaped = true,
                Some((_, quote)) if c == quote => open = None,
                None if c == '#' => return Self::Comment,
                None if matches!(c, '"' | '\'') => open = Some((place, c)),
                _ => {}
            }
        }
        open.map_or(Self::Code, |(start, _)| Self::Quote(start))
    }
}

impl Builder<'_> {
    fn cursor(&self, line: &str) -> Cursor {
        let table = self.table();
        let header = || table.map(|table| names(&table.path).map(str::to_owned).collect::<Vec<_>>());
        if self.is_header && self.open.is_empty() && line.trim_start().starts_with('[') {
            let around = names(&self.key).map(str::to_owned).collect();
            return Cursor { around, slot: Slot::Header, siblings: Vec::new() };
        }
        let mut around = header().unwrap_or_default();
        let mut items = table.map_or(&[][..], |table: &Headed| &table.items);
        let mut in_list = false;
        for open in &self.open {
            // an element of a list has no key of its own
            if !in_list {
                around.extend(last_key(items));
            }
            in_list = matches!(open, Open::List { .. });
            if let Open::Table { items: inner, .. } = open {
                items = inner;
            }
        }
        let siblings = items.iter().filter_map(|item| item.path.first()).map(|key| key.name.clone());
        let siblings: Vec<String> = siblings.collect();
        if in_list {
            let key = around.pop().unwrap_or_default();
            return Cursor { around, slot: Slot::Value(key), siblings };
        }
        if self.waits {
            let mut keys = last_key(items);
            let key = keys.pop().unwrap_or_default();
            around.extend(keys);
            return Cursor { around, slot: Slot::Value(key), siblings };
        }
        // what stands before a dot is around what comes behind it
        around.extend(names(&self.key).map(str::to_owned));
        Cursor { around, slot: Slot::Key, siblings }
    }
}

/// The parts of the key that the last line has and whose value is open.
fn last_key(items: &[super::Item]) -> Vec<String> {
    let open = items.last().filter(|item| item.value.is_none());
    open.map_or_else(Vec::new, |item| names(&item.path as &[Key]).map(str::to_owned).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn stands(text: &str, around: &[&str], slot: Slot) {
        let cursor = Cursor::at(text, text.len());
        assert_eq!(
            (cursor.around, cursor.slot),
            (around.iter().map(|it| (*it).to_owned()).collect(), slot),
            "{text}"
        );
    }

    #[test]
    fn one_is_where_one_writes() {
        let value = |key: &str| Slot::Value(key.to_owned());
        stands("", &[], Slot::Key);
        stands("[", &[], Slot::Header);
        stands("[obj", &[], Slot::Header);
        stands("a = 1\n[objects.", &["objects"], Slot::Header);
        stands("[objects.0x60", &["objects"], Slot::Header);
        stands("[[err", &[], Slot::Header);
        stands("[objects.0x6064]\n", &["objects", "0x6064"], Slot::Key);
        stands("[a]\nb = 1\nna", &["a"], Slot::Key);
        stands("[a]\nb.c", &["a", "b"], Slot::Key);
        stands("[a]\nb = ", &["a"], value("b"));
        stands("[a]\nb = \"x", &["a"], value("b"));
        stands("[a]\nb = \"x y\\\" z", &["a"], value("b"));
        stands("[a]\nb.c = tr", &["a", "b"], value("c"));
        stands("[a]\nb = [\"x\", ", &["a"], value("b"));
        stands("[a]\nb = [\n  \"x\",\n  \"", &["a"], value("b"));
        stands("[a]\nb = { ", &["a", "b"], Slot::Key);
        stands("[a]\nb = { c = 1, d = ", &["a", "b"], value("d"));
        stands("[a]\nb = [{ c = \"x\" }, { d", &["a", "b"], Slot::Key);
        stands("[a]\nb = [[", &["a"], value("b"));
        stands("[a]\nb = { c = [{ e = 1 }], ", &["a", "b"], Slot::Key);
        stands("[a]\nb = 1 # c", &[], Slot::Prose);
        stands("[a]\nb = \"\"\"\nsome text", &[], Slot::Prose);
        stands("[a]\nb = \"# no comment\"\nc", &["a"], Slot::Key);
    }

    #[test]
    fn what_is_there_already_is_known() {
        let text = "[a]\nb = 1\nc = { d = 1, ";
        assert_eq!(Cursor::at(text, text.len()).siblings, ["d"]);
        assert_eq!(Cursor::at("[a]\nb = 1\nc.d = 2\n", 20).siblings, ["b", "c"]);
    }
}
