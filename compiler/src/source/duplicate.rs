//! Where a key that is defined twice was defined first.
//!
//! The TOML parser only tells the second place. This walks the text once more, which costs nothing as long
//! as there is no such error.

use std::ops::Range;

use toml_parser::Source;
use toml_parser::parser::{Event, EventKind, parse_document};

/// The last definition of the same key before the one at `again`: since the key is a duplicate, that one lies
/// in the same table, even where tables of an array repeat their keys.
pub(super) fn first_definition(text: &str, again: &Range<usize>) -> Option<Range<usize>> {
    let source = Source::new(text);
    let mut walk =
        Walk { source, scopes: vec![Vec::new()], key: Vec::new(), value: Vec::new(), found: Vec::new() };
    let tokens = source.lex().into_vec();
    parse_document(&tokens, &mut |event: Event| walk.event(event), &mut ());
    let (path, _) = walk.found.iter().find(|(_, at)| at == again)?;
    let earlier = walk.found.iter().rev().find(|(other, at)| other == path && at.start < again.start);
    earlier.map(|(_, at)| at.clone())
}

/// Keys from the root of the file down.
type Path = Vec<String>;

struct Walk<'t> {
    source: Source<'t>,
    /// The paths of the tables and arrays around the current place; never empty.
    scopes: Vec<Path>,
    /// The parts of the key being read.
    key: Vec<(String, Range<usize>)>,
    /// The path of the value being read.
    value: Path,
    /// Every definition so far.
    found: Vec<(Path, Range<usize>)>,
}

impl Walk<'_> {
    fn event(&mut self, event: Event) {
        match event.kind() {
            EventKind::StdTableOpen | EventKind::ArrayTableOpen => self.scopes = vec![Vec::new()],
            EventKind::SimpleKey => self.part(event),
            EventKind::StdTableClose | EventKind::ArrayTableClose => {
                self.define();
                self.scopes = vec![self.value.clone()];
            }
            EventKind::KeyValSep => self.define(),
            EventKind::InlineTableOpen | EventKind::ArrayOpen => self.scopes.push(self.value.clone()),
            EventKind::InlineTableClose | EventKind::ArrayClose if self.scopes.len() > 1 => {
                self.value = self.scopes.pop().unwrap_or_default();
            }
            _ => {}
        }
    }

    fn part(&mut self, event: Event) {
        let mut name = String::new();
        if let Some(raw) = self.source.get(event) {
            raw.decode_key(&mut name, &mut ());
        }
        self.key.push((name, event.span().start()..event.span().end()));
    }

    fn define(&mut self) {
        self.value = self.scopes.last().cloned().unwrap_or_default();
        for (name, at) in self.key.drain(..) {
            self.value.push(name);
            self.found.push((self.value.clone(), at));
        }
    }
}
