//! Text to [`Table`].

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::num::IntErrorKind;
use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeTable, DeValue};

use super::characters::{Odd, escaped, raw};
use super::duplicate::Keys;
use super::{CanonicalKey, FileId, Key, Layer, Location, Member, Node, Table, Value, limits};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::text::characters::first_hazard;

/// Reads a text as TOML and reports every syntax error in it, every character that no text may hold, and what is
/// longer or lies deeper than it may.
///
/// What can be read in spite of the errors is in the table, as set by `layer`.
pub(crate) fn parse(file: FileId, text: &str, layer: Layer, diagnostics: &mut Diagnostics) -> Table {
    let (root, errors) = DeTable::parse_recoverable(text);
    let mut parser = Parser { file, layer, text, keys: None, diagnostics };
    for error in errors {
        parser.syntax_error(&error);
    }
    raw(text).for_each(|odd| parser.odd(&odd, 0, "a file"));
    parser.table(root.get_ref(), 0..text.len(), 0)
}

struct Parser<'a> {
    file: FileId,
    layer: Layer,
    text: &'a str,
    /// What a second look at the text found, if it was needed.
    keys: Option<Keys>,
    diagnostics: &'a mut Diagnostics,
}

impl Parser<'_> {
    fn table(&mut self, table: &DeTable<'_>, at: Range<usize>, depth: usize) -> Table {
        let members = table.iter().map(|(key, value)| self.member(key, value, depth));
        let mut members: Vec<Member> = members.collect();
        // The parser sorts by name; people wrote in an order of their own.
        members.sort_by_key(|member| member.key.at.start);
        self.same_numbers(&mut members);
        Table { at: self.at(at), members: members.into() }
    }

    /// Reports numbers that are a key twice, in two spellings, and keeps the first.
    fn same_numbers(&mut self, members: &mut Vec<Member>) {
        let mut known: BTreeMap<CanonicalKey, Key> = BTreeMap::new();
        members.retain(|member| {
            let CanonicalKey::Range(..) = member.key.canonical else { return true };
            let first = known.get(&member.key.canonical);
            if let Some(first) = first {
                let message = format!("`{}` and `{}` are the same key", first.name, member.key.name);
                let fault =
                    Diagnostic::new(&faults::DUPLICATE_DEFINITION, message, member.key.at, "again here");
                self.diagnostics.push(fault.label(first.at, "first here").help("keep one of the two"));
                return false;
            }
            known.insert(member.key.canonical.clone(), member.key.clone());
            true
        });
    }

    fn member(&mut self, key: &Spanned<Cow<'_, str>>, value: &Spanned<DeValue<'_>>, depth: usize) -> Member {
        let (name, at) = (&**key.get_ref(), self.at(key.span()));
        self.diagnostics.extend(limits::key(name, at));
        self.characters(name, &key.span(), true);
        Member { key: Key::new(name, at), node: self.node(value, depth), layer: self.layer, under: None }
    }

    fn node(&mut self, value: &Spanned<DeValue<'_>>, depth: usize) -> Node {
        let (span, at) = (value.span(), self.at(value.span()));
        let value = match value.get_ref() {
            DeValue::String(text) => self.string(text, span),
            DeValue::Integer(integer) => self.integer(integer, at),
            DeValue::Float(float) => self.float(float, at),
            DeValue::Boolean(boolean) => Value::Boolean(*boolean),
            DeValue::Datetime(datetime) => Value::Datetime(Arc::from(datetime.to_string())),
            DeValue::Array(_) | DeValue::Table(_) if depth >= limits::NESTING => {
                self.diagnostics.push(limits::nesting(at));
                Value::Array(Arc::default())
            }
            DeValue::Array(items) => {
                Value::Array(items.iter().map(|item| self.node(item, depth + 1)).collect())
            }
            DeValue::Table(table) => Value::Table(Arc::new(self.table(table, span, depth + 1))),
        };
        Node { at, value }
    }

    fn string(&mut self, text: &str, span: Range<usize>) -> Value {
        self.diagnostics.extend(limits::text(text, self.at(span.clone())));
        // a text is the same whether a file ends its lines in the way of Windows or not
        let text =
            if text.contains('\r') { Cow::Owned(text.replace("\r\n", "\n")) } else { Cow::Borrowed(text) };
        self.characters(&text, &span, false);
        Value::String(Arc::from(text))
    }

    /// Reports what a key or a string stands for by escapes and may not hold.
    fn characters(&mut self, text: &str, span: &Range<usize>, is_key: bool) {
        if first_hazard(text).is_none() && !(is_key && text.contains(['\n', '\t'])) {
            return;
        }
        let holder = if is_key { "a key" } else { "a text" };
        let written = self.text.get(span.clone()).unwrap_or_default();
        escaped(written, is_key).iter().for_each(|odd| self.odd(odd, span.start, holder));
    }

    fn odd(&mut self, odd: &Odd, start: usize, holder: &str) {
        let at = self.at(start + odd.at.start..start + odd.at.end);
        let message = format!("U+{:04X} is {}", u32::from(odd.c), odd.what);
        let label = format!("{holder} cannot hold it");
        let fault = Diagnostic::new(&faults::FORBIDDEN_CHARACTER, message, at, label);
        self.diagnostics.push(fault.fix("leave it out", at, ""));
    }

    fn integer(&mut self, integer: &DeInteger<'_>, at: Location) -> Value {
        let number = i128::from_str_radix(integer.as_str(), integer.radix()).unwrap_or_else(|error| {
            match error.kind() {
                IntErrorKind::PosOverflow | IntErrorKind::NegOverflow => {
                    self.report(format!("the integer {integer} is too large"), at, "does not fit 128 bits");
                }
                _ => self.report(format!("`{integer}` is not an integer"), at, "expected digits"),
            }
            0
        });
        Value::Integer(number)
    }

    fn float(&mut self, float: &DeFloat<'_>, at: Location) -> Value {
        let text = float.as_str();
        let value = text.parse().unwrap_or(f64::NAN);
        if text.contains("inf") || text.contains("nan") {
            let message = format!("`{text}` is no value that a drive could have");
            let fault = Diagnostic::new(&faults::INVALID_VALUE, message, at, "expected a number");
            self.diagnostics.push(fault.help("leave the key out if there is no value or no limit"));
        } else if value.is_infinite() {
            self.report(format!("the float {text} is too large"), at, "does not fit 64 bits");
        }
        Value::Float(value)
    }

    fn syntax_error(&mut self, error: &toml::de::Error) {
        let span = error.span().unwrap_or_default();
        match error.message() {
            "duplicate key" => return self.duplicate(span),
            "recursion limit" => {
                let longest = self.keys().longest();
                return self.diagnostics.push(limits::nesting(self.at(longest)));
            }
            "cannot recurse further; max recursion depth met" => {
                return self.diagnostics.push(limits::nesting(self.at(span)));
            }
            _ => {}
        }
        let (what, expected) = match error.message().split_once(", expected ") {
            // What the parser says of `key =` with nothing behind it.
            Some(("string values must be quoted", _)) if span.is_empty() => {
                ("a value is missing", String::new())
            }
            Some((what, quote)) if what.ends_with(" string") && quote.contains(['"', '\'']) => {
                ("a string does not end", format!("expected {quote}"))
            }
            Some((what, expected)) => (what, format!("expected {expected}")),
            None => (error.message(), String::new()),
        };
        let at = self.at(span);
        self.report(format!("this is not TOML: {what}"), at, &expected);
    }

    fn duplicate(&mut self, span: Range<usize>) {
        if span.is_empty() {
            // a key that is not there was reported already
            return;
        }
        let key = self.text.get(span.clone()).unwrap_or_default();
        let message = format!("`{key}` is defined twice");
        let first = self.keys().first(span.start);
        let fault = Diagnostic::new(&faults::INVALID_TOML, message, self.at(span), "defined again here");
        let first = first.map(|first| self.at(first));
        self.diagnostics
            .push(first.into_iter().fold(fault, |fault, first| fault.label(first, "first defined here")));
    }

    fn keys(&mut self) -> &Keys {
        self.keys.get_or_insert_with(|| Keys::of(self.text))
    }

    fn report(&mut self, message: String, at: Location, label: &str) {
        self.diagnostics.push(Diagnostic::new(&faults::INVALID_TOML, message, at, label));
    }

    fn at(&self, span: Range<usize>) -> Location {
        let offset = |offset| u32::try_from(offset).unwrap_or(u32::MAX);
        Location { file: self.file, start: offset(span.start), end: offset(span.end) }
    }
}
