//! Text to [`Table`].

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::num::IntErrorKind;
use std::ops::Range;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeFloat, DeInteger, DeTable, DeValue};

use super::duplicate::first_definition;
use super::{CanonicalKey, FileId, Key, Layer, Location, Member, Node, Table, Value};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};

/// Reads a text as TOML and reports every syntax error in it.
///
/// What can be read in spite of the errors is in the table, as set by `layer`.
pub(crate) fn parse(file: FileId, text: &str, layer: Layer, diagnostics: &mut Diagnostics) -> Table {
    let (root, errors) = DeTable::parse_recoverable(text);
    let mut parser = Parser { file, layer, diagnostics };
    for error in errors {
        parser.syntax_error(text, &error);
    }
    parser.table(root.get_ref(), 0..text.len())
}

struct Parser<'a> {
    file: FileId,
    layer: Layer,
    diagnostics: &'a mut Diagnostics,
}

impl Parser<'_> {
    fn table(&mut self, table: &DeTable<'_>, at: Range<usize>) -> Table {
        let mut members: Vec<Member> = table.iter().map(|(key, value)| self.member(key, value)).collect();
        // The parser sorts by name; people wrote in an order of their own.
        members.sort_by_key(|member| member.key.at.start);
        self.same_numbers(&mut members);
        Table { at: self.at(at), members }
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

    fn member(&mut self, key: &Spanned<Cow<'_, str>>, value: &Spanned<DeValue<'_>>) -> Member {
        let key = Key::new(key.get_ref(), self.at(key.span()));
        Member { key, node: self.node(value), layer: self.layer, under: None }
    }

    fn node(&mut self, value: &Spanned<DeValue<'_>>) -> Node {
        let at = self.at(value.span());
        let value = match value.get_ref() {
            DeValue::String(text) => Value::String(Arc::from(&**text)),
            DeValue::Integer(integer) => self.integer(integer, at),
            DeValue::Float(float) => self.float(float, at),
            DeValue::Boolean(boolean) => Value::Boolean(*boolean),
            DeValue::Datetime(datetime) => Value::Datetime(Arc::from(datetime.to_string())),
            DeValue::Array(items) => Value::Array(items.iter().map(|item| self.node(item)).collect()),
            DeValue::Table(table) => Value::Table(Arc::new(self.table(table, value.span()))),
        };
        Node { at, value }
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
        if value.is_infinite() && !text.contains("inf") {
            self.report(format!("the float {text} is too large"), at, "does not fit 64 bits");
        }
        Value::Float(value)
    }

    fn syntax_error(&mut self, text: &str, error: &toml::de::Error) {
        let span = error.span().unwrap_or_default();
        if error.message() == "duplicate key" {
            return self.duplicate(text, span);
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

    fn duplicate(&mut self, text: &str, span: Range<usize>) {
        let key = text.get(span.clone()).unwrap_or_default();
        let at = self.at(span.clone());
        let message = format!("`{key}` is defined twice");
        let mut diagnostic = Diagnostic::new(&faults::INVALID_TOML, message, at, "defined again here");
        if let Some(first) = first_definition(text, &span) {
            diagnostic = diagnostic.label(self.at(first), "first defined here");
        }
        self.diagnostics.push(diagnostic);
    }

    fn report(&mut self, message: String, at: Location, label: &str) {
        self.diagnostics.push(Diagnostic::new(&faults::INVALID_TOML, message, at, label));
    }

    fn at(&self, span: Range<usize>) -> Location {
        let offset = |offset| u32::try_from(offset).unwrap_or(u32::MAX);
        Location { file: self.file, start: offset(span.start), end: offset(span.end) }
    }
}
