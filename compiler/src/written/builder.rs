//! From the events of a TOML parser to what is written.

use std::borrow::Cow;
use std::ops::Range;

use toml_parser::Source;
use toml_parser::decoder::Encoding;
use toml_parser::parser::{Event, EventKind, RecursionGuard, parse_document};

use super::{Headed, Item, Key, Kind, Value, Written};

/// How deep brackets may lie in one another; what lies deeper no description has.
const DEPTH: u32 = 64;

/// What has been read so far.
pub(super) struct Builder<'t> {
    source: Source<'t>,
    written: Written,
    /// The lists and tables in braces that are open, the outermost first.
    pub(super) open: Vec<Open>,
    /// The parts of a key that is being read.
    pub(super) key: Vec<Key>,
    /// Whether a header is open.
    pub(super) is_header: bool,
    /// Whether a key waits for its value.
    pub(super) waits: bool,
    /// Whether the text ends in a string of several lines.
    pub(super) in_prose: bool,
}

/// A list or a table in braces of which the end has not been read.
pub(super) enum Open {
    List { start: usize, values: Vec<Value> },
    Table { start: usize, items: Vec<Item> },
}

impl<'t> Builder<'t> {
    pub(super) fn read(text: &'t str) -> Self {
        let source = Source::new(text);
        let mut written = Written::default();
        written.tables.push(Headed::default());
        let (open, key) = (Vec::new(), Vec::new());
        let mut builder =
            Self { source, written, open, key, is_header: false, waits: false, in_prose: false };
        let tokens = source.lex().into_vec();
        let mut take = |event: Event| builder.event(event);
        parse_document(&tokens, &mut RecursionGuard::new(&mut take, DEPTH), &mut ());
        builder
    }

    /// All that was read; what is open ends with the text.
    pub(super) fn finish(mut self) -> Written {
        self.flush();
        let end = self.source.input().len();
        while !self.open.is_empty() {
            self.close(end);
            self.flush();
        }
        self.written
    }

    /// The table whose lines are being read.
    pub(super) fn table(&self) -> Option<&Headed> {
        self.written.tables.last()
    }

    fn event(&mut self, event: Event) {
        let at = event.span().start()..event.span().end();
        match event.kind() {
            EventKind::StdTableOpen | EventKind::ArrayTableOpen => self.header(at, event.kind()),
            // of a header that its author has not closed yet
            EventKind::StdTableClose | EventKind::ArrayTableClose if at.is_empty() => {}
            EventKind::StdTableClose | EventKind::ArrayTableClose => self.end_of_header(at.end),
            EventKind::SimpleKey if at.is_empty() => {}
            EventKind::SimpleKey => self.part(event, at),
            EventKind::KeyValSep => self.begin(),
            // of a value that is not there yet
            EventKind::Scalar if at.is_empty() => {}
            EventKind::Scalar => {
                let is_long =
                    matches!(event.encoding(), Some(Encoding::MlBasicString | Encoding::MlLiteralString));
                self.in_prose = is_long && at.end == self.source.input().len();
                let kind = self.scalar(event);
                self.value(Value { at, kind });
            }
            EventKind::ArrayOpen => self.open.push(Open::List { start: at.start, values: Vec::new() }),
            EventKind::InlineTableOpen => {
                self.waits = false;
                self.open.push(Open::Table { start: at.start, items: Vec::new() });
            }
            // what nobody has closed yet ends with the text
            EventKind::ArrayClose | EventKind::InlineTableClose if self.is_rest(&at) => {}
            EventKind::ArrayClose | EventKind::InlineTableClose => {
                self.flush();
                self.close(at.end);
            }
            EventKind::ValueSep => self.flush(),
            EventKind::Newline if self.open.is_empty() => self.flush(),
            EventKind::Comment => self.written.comments.push(at),
            _ => {}
        }
    }

    /// Whether nothing stands at a place, nor behind it.
    fn is_rest(&self, at: &Range<usize>) -> bool {
        at.is_empty() && self.source.input().get(at.end..).is_some_and(|rest| rest.trim().is_empty())
    }

    fn header(&mut self, at: Range<usize>, kind: EventKind) {
        self.flush();
        // whatever was open above has not been closed by its author yet
        while !self.open.is_empty() {
            self.close(at.start);
            self.flush();
        }
        self.is_header = true;
        let is_element = kind == EventKind::ArrayTableOpen;
        self.written.tables.push(Headed { header: at, is_element, ..Headed::default() });
    }

    fn end_of_header(&mut self, end: usize) {
        self.is_header = false;
        let path = std::mem::take(&mut self.key);
        if let Some(table) = self.written.tables.last_mut() {
            table.header.end = end;
            table.path = path;
        }
    }

    fn part(&mut self, event: Event, at: Range<usize>) {
        let mut name = Cow::Borrowed("");
        if let Some(raw) = self.source.get(event) {
            raw.decode_key(&mut name, &mut ());
        }
        self.key.push(Key { name: name.into_owned(), at });
    }

    fn scalar(&self, event: Event) -> Kind {
        let raw = self.source.get(event);
        let is_text = event.encoding().is_some_and(|encoding| {
            matches!(
                encoding,
                Encoding::BasicString
                    | Encoding::LiteralString
                    | Encoding::MlBasicString
                    | Encoding::MlLiteralString
            )
        });
        match raw.filter(|_| is_text) {
            Some(raw) => {
                let mut text = Cow::Borrowed("");
                let _ = raw.decode_scalar(&mut text, &mut ());
                Kind::Text(text.into_owned())
            }
            None => Kind::Other,
        }
    }

    /// A key has been read and its value follows.
    fn begin(&mut self) {
        self.waits = false;
        self.flush();
        self.waits = true;
    }

    /// Keeps a key that was read, with no value yet.
    fn flush(&mut self) {
        self.waits = false;
        if self.key.is_empty() {
            return;
        }
        let path = std::mem::take(&mut self.key);
        if self.is_header {
            self.is_header = false;
            if let Some(table) = self.written.tables.last_mut() {
                table.header.end = path.last().map_or(table.header.end, |key| key.at.end);
                table.path = path;
            }
            return;
        }
        if let Some(items) = self.items() {
            items.push(Item { path, value: None });
        }
    }

    /// The lines that a key would be added to.
    fn items(&mut self) -> Option<&mut Vec<Item>> {
        match self.open.last_mut() {
            Some(Open::Table { items, .. }) => Some(items),
            Some(Open::List { .. }) => None,
            None => self.written.tables.last_mut().map(|table| &mut table.items),
        }
    }

    fn value(&mut self, value: Value) {
        self.waits = false;
        if let Some(Open::List { values, .. }) = self.open.last_mut() {
            values.push(value);
            return;
        }
        let last = self.items().and_then(|items| items.last_mut());
        if let Some(item) = last.filter(|item| item.value.is_none()) {
            item.value = Some(value);
        }
    }

    fn close(&mut self, end: usize) {
        let value = match self.open.pop() {
            Some(Open::List { start, values }) => Value { at: start..end, kind: Kind::List(values) },
            Some(Open::Table { start, items }) => Value { at: start..end, kind: Kind::Table(items) },
            None => return,
        };
        self.value(value);
    }
}
