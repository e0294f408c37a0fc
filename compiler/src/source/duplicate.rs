//! Where a key that is defined twice was defined first, and where keys nest too deep.
//!
//! The TOML parser tells neither. This walks the text once more, which costs nothing as long as there is no such
//! error.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

use toml_parser::Source;
use toml_parser::parser::{Event, EventKind, RecursionGuard, parse_document};

use super::limits::NESTING;

/// What a second look at a text finds.
#[derive(Default)]
pub(super) struct Keys {
    /// The first definition of each key that is defined again, by the start of the later one. It lies in the same
    /// table, even where tables of an array repeat their keys.
    first: BTreeMap<usize, Range<usize>>,
    /// The key with the most parts.
    longest: Range<usize>,
}

impl Keys {
    /// Looks at all keys of a text.
    pub(super) fn of(text: &str) -> Self {
        let source = Source::new(text);
        let mut walk = Walk::new(source);
        let tokens = source.lex().into_vec();
        let mut take = |event: Event| walk.event(event);
        // the parser calls itself for each bracket in a bracket
        let depth = u32::try_from(NESTING).unwrap_or(u32::MAX);
        parse_document(&tokens, &mut RecursionGuard::new(&mut take, depth), &mut ());
        walk.keys
    }

    /// The first definition of the key that is defined again at this byte.
    pub(super) fn first(&self, again: usize) -> Option<Range<usize>> {
        self.first.get(&again).cloned()
    }

    /// The place of the key with the most parts.
    pub(super) fn longest(&self) -> Range<usize> {
        self.longest.clone()
    }
}

/// Tables, arrays and values by number; 0 is the root of the file.
#[derive(Default)]
struct Tables<'t> {
    known: BTreeMap<(usize, Cow<'t, str>), (usize, Range<usize>)>,
    /// The last number given.
    last: usize,
    /// The newest element of each array of tables, by its number.
    newest: BTreeMap<usize, usize>,
}

impl<'t> Tables<'t> {
    fn add(&mut self) -> usize {
        self.last += 1;
        self.last
    }

    /// The number of what stands under a name, with the first place of the name if this is another.
    fn named(
        &mut self,
        parent: usize,
        name: Cow<'t, str>,
        at: &Range<usize>,
    ) -> (usize, Option<Range<usize>>) {
        let parent = self.newest.get(&parent).copied().unwrap_or(parent);
        let next = self.last + 1;
        let (number, first) = self.known.entry((parent, name)).or_insert_with(|| (next, at.clone()));
        self.last = self.last.max(*number);
        (*number, (first != at).then(|| first.clone()))
    }
}

struct Walk<'t> {
    source: Source<'t>,
    tables: Tables<'t>,
    /// The tables and arrays around the current place; never empty.
    scopes: Vec<usize>,
    /// The parts of the key being read.
    key: Vec<(Cow<'t, str>, Range<usize>)>,
    /// The value being read.
    value: usize,
    /// The number of parts of the longest key.
    most: usize,
    keys: Keys,
}

impl<'t> Walk<'t> {
    fn new(source: Source<'t>) -> Self {
        let (tables, key, keys) = (Tables::default(), Vec::new(), Keys::default());
        Self { source, tables, scopes: vec![0], key, value: 0, most: 0, keys }
    }

    fn event(&mut self, event: Event) {
        match event.kind() {
            EventKind::StdTableOpen | EventKind::ArrayTableOpen => self.scopes = vec![0],
            EventKind::SimpleKey => self.part(event),
            EventKind::StdTableClose => {
                self.define();
                self.scopes = vec![self.value];
            }
            EventKind::ArrayTableClose => {
                self.define();
                let element = self.tables.add();
                self.tables.newest.insert(self.value, element);
                self.scopes = vec![element];
            }
            EventKind::KeyValSep => self.define(),
            EventKind::ArrayOpen => self.scopes.push(self.value),
            EventKind::InlineTableOpen => {
                // one in an array has keys of its own
                let table = self.tables.add();
                self.scopes.push(table);
            }
            EventKind::InlineTableClose | EventKind::ArrayClose if self.scopes.len() > 1 => {
                self.scopes.pop();
            }
            _ => {}
        }
    }

    fn part(&mut self, event: Event) {
        let mut name = Cow::Borrowed("");
        if let Some(raw) = self.source.get(event) {
            raw.decode_key(&mut name, &mut ());
        }
        self.key.push((name, event.span().start()..event.span().end()));
    }

    fn define(&mut self) {
        self.value = self.scopes.last().copied().unwrap_or_default();
        if self.key.len() > self.most {
            self.most = self.key.len();
            let (start, end) = (self.key.first(), self.key.last());
            self.keys.longest = start.map_or(0, |(_, at)| at.start)..end.map_or(0, |(_, at)| at.end);
        }
        for (name, at) in self.key.drain(..) {
            let (number, first) = self.tables.named(self.value, name, &at);
            self.value = number;
            self.keys.first.extend(first.map(|first| (at.start, first)));
        }
    }
}
