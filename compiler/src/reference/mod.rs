//! The format, to be asked: which keys a table can have, what they mean, and what their values can be.
//!
//! It is read from the JSON schema, which is made of the structs that descriptions are read into.

pub(crate) mod relation;

use std::sync::OnceLock;

use serde_json::{Map, Value};

/// The schema of descriptions, as the tests hold it to the code.
pub const SCHEMA: &str = include_str!("../../schema/device.schema.json");

/// What can stand at a place of a description.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shape {
    root: &'static Value,
    at: &'static Value,
}

/// A word that a value can be, with what it means.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Choice {
    /// As it is written, a string with its quotes.
    pub(crate) written: String,
    /// What it means; may be empty.
    pub(crate) about: String,
}

impl Shape {
    /// A file of a description.
    pub(crate) fn file() -> Self {
        static ROOT: OnceLock<Value> = OnceLock::new();
        let root = ROOT.get_or_init(|| serde_json::from_str(SCHEMA).unwrap_or_default());
        Self { root, at: root }
    }

    /// What stands at a path from the top of a file; the elements of a list have no key of their own.
    pub(crate) fn find<'k>(path: impl IntoIterator<Item = &'k str>) -> Option<Self> {
        path.into_iter().try_fold(Self::file(), |shape, key| shape.under(key))
    }

    /// What stands under a key.
    pub(crate) fn under(self, key: &str) -> Option<Self> {
        let shape = self.resolved();
        if let Some(items) = shape.at.get("items") {
            return shape.with(items).under(key);
        }
        if let Some(any) = shape.at.get("anyOf").and_then(Value::as_array) {
            return any.iter().find_map(|one| shape.with(one).under(key));
        }
        let named = shape.at.get("properties").and_then(|keys| keys.get(key));
        let other = || shape.at.get("additionalProperties").filter(|other| other.is_object());
        named.or_else(other).map(|at| shape.with(at))
    }

    /// The keys that are known by name, in the order in which they are explained, with what stands under each.
    pub(crate) fn keys(self) -> Vec<(&'static str, Self)> {
        let shape = self.resolved();
        if let Some(items) = shape.at.get("items") {
            return shape.with(items).keys();
        }
        let any = shape.at.get("anyOf").and_then(Value::as_array).into_iter().flatten();
        let inside = any.flat_map(|one| shape.with(one).keys());
        let own = shape.at.get("properties").and_then(Value::as_object).into_iter().flat_map(Map::iter);
        own.map(|(key, at)| (key.as_str(), shape.with(at))).chain(inside).collect()
    }

    /// What it means.
    pub(crate) fn about(self) -> &'static str {
        let own = |at: &'static Value| at.get("description").and_then(Value::as_str);
        own(self.at).or_else(|| own(self.resolved().at)).unwrap_or_default()
    }

    /// The words that a value can be.
    pub(crate) fn choices(self) -> Vec<Choice> {
        let shape = self.resolved();
        let about = || shape.at.get("description").and_then(Value::as_str).unwrap_or_default();
        let choice = |value: &Value| Choice { written: value.to_string(), about: about().to_owned() };
        let inside = ["anyOf", "oneOf"].into_iter().filter_map(|key| shape.at.get(key)?.as_array());
        let inside = inside.flatten().flat_map(|one| shape.with(one).choices());
        let items = shape.at.get("items").map(|items| shape.with(items).choices()).unwrap_or_default();
        let words = shape.at.get("enum").and_then(Value::as_array).into_iter().flatten();
        let one = shape.at.get("const");
        let mut choices: Vec<Choice> = words.chain(one).map(choice).chain(inside).chain(items).collect();
        if shape.is("boolean") {
            choices
                .extend(["true", "false"].map(|word| Choice { written: word.into(), about: String::new() }));
        }
        choices
    }

    /// Whether a value can be of this kind of JSON.
    pub(crate) fn is(self, kind: &str) -> bool {
        let shape = self.resolved();
        let any = shape.at.get("anyOf").and_then(Value::as_array).into_iter().flatten();
        match shape.at.get("type") {
            Some(Value::String(one)) => one == kind,
            Some(Value::Array(kinds)) => kinds.iter().any(|one| one == kind),
            _ => any.map(|one| shape.with(one)).any(|one| one.is(kind)),
        }
    }

    fn with(self, at: &'static Value) -> Self {
        Self { at, ..self }
    }

    /// Where a reference leads.
    fn resolved(self) -> Self {
        let name = self.at.get("$ref").and_then(Value::as_str).and_then(|to| to.strip_prefix("#/$defs/"));
        let definition = name.and_then(|name| self.root.get("$defs")?.get(name));
        definition.map_or(self, |at| self.with(at))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_found_wherever_they_are_written() {
        let about = |path: &[&str]| Shape::find(path.iter().copied()).map(Shape::about).unwrap_or_default();
        for path in [
            &["objects", "0x6064", "unit"][..],
            &["objects", "0x6064", "entries", "1", "unit"],
            &["objects", "0x6064", "per-axis", "Y", "unit"],
            &["members", "a", "objects", "0x6064", "unit"],
        ] {
            assert_eq!(about(path), "The unit of its value, one of `[units]`.", "{path:?}");
        }
        assert_eq!(about(&["errata", "rule"]), "The rule that found it.");
        assert!(Shape::find(["objects", "0x6064", "colour"]).is_none());
    }

    #[test]
    fn closed_words_are_known() {
        let words = |path: &[&str]| {
            let choices = Shape::find(path.iter().copied()).map(Shape::choices).unwrap_or_default();
            choices.into_iter().map(|choice| choice.written).collect::<Vec<_>>()
        };
        assert_eq!(words(&["objects", "0x1", "access"]), ["\"ro\"", "\"wo\"", "\"rw\"", "\"const\""]);
        assert_eq!(words(&["rx-pdos", "0x1600", "fixed"]), ["true", "false"]);
        assert!(words(&["mailbox", "protocols"]).contains(&"\"CoE\"".to_owned()));
    }
}
