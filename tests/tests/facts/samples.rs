//! Values for a key, after its schema: one of them must change something or be answered.

use serde_json::Value as Json;
use toml::{Table, Value};

use crate::places::resolved;

/// Values that a key may hold.
pub(crate) fn samples(key: &str, holds: &Json, schema: &Json) -> Vec<Value> {
    if key == "write" {
        return vec![Value::Integer(2)]; // it has to fit the entry
    }
    let holds = resolved(holds, schema);
    if let Some(words) = holds.get("oneOf").and_then(Json::as_array) {
        let words = words.iter().filter_map(|word| word["const"].as_str());
        return words.map(Value::from).collect();
    }
    if let Some(choices) = holds.get("anyOf").and_then(Json::as_array) {
        return choices.iter().flat_map(|choice| samples(key, choice, schema)).collect();
    }
    if let Some(value) = holds.get("const") {
        return vec![Value::Boolean(value.as_bool().unwrap_or_default())];
    }
    let kinds: Vec<&str> = match &holds["type"] {
        Json::String(kind) => vec![kind],
        Json::Array(kinds) => kinds.iter().filter_map(Json::as_str).collect(),
        _ => Vec::new(),
    };
    kinds.into_iter().flat_map(|kind| of_kind(kind, key, &holds, schema)).collect()
}

fn of_kind(kind: &str, key: &str, holds: &Json, schema: &Json) -> Vec<Value> {
    match kind {
        "boolean" => vec![Value::Boolean(true), Value::Boolean(false)],
        "integer" | "number" => vec![Value::Integer(2), Value::Integer(1), Value::Integer(0)],
        "string" => texts(key),
        "array" => {
            let items = samples(key, &holds["items"], schema);
            items.into_iter().map(|item| Value::Array(vec![item])).collect()
        }
        "object" => tables(key, holds, schema),
        other => panic!("{other} is no kind of TOML"),
    }
}

/// Texts that are read as something, and one that is only a text.
fn texts(key: &str) -> Vec<Value> {
    let read = match key {
        "type" => "UINT32",
        "during" => "PS",
        "pattern" => "x1xx xx10",
        "at" => "identity.serial",
        "range" => "0x3000..=0x30FF",
        _ => "a new fact",
    };
    let known = ["0x2001", "0x6040", "0x1600", "speed", "fault", "op", "2 ms", "1/3", "0A0B0C", read];
    known.into_iter().rev().map(Value::from).collect()
}

/// A table with one key, or with all that it needs.
fn tables(key: &str, holds: &Json, schema: &Json) -> Vec<Value> {
    let table = |key: &str, value: Value| Value::Table(Table::from_iter([(key.to_owned(), value)]));
    if let Some(keys) = holds.get("properties").and_then(Json::as_object) {
        let all = keys
            .iter()
            .filter_map(|(key, holds)| Some((key.clone(), samples(key, holds, schema).first()?.clone())));
        return vec![Value::Table(all.collect())];
    }
    let inner = holds.get("additionalProperties").filter(|inner| inner.is_object());
    let inner = inner.map_or_else(|| vec![Value::from("a new fact")], |inner| samples(key, inner, schema));
    let languages = ["names", "texts", "urls"].contains(&key).then_some("de");
    let names = languages.into_iter().chain(["1", "0x6040", "0x1600", "B", "about", "Z"]);
    names.flat_map(|name| inner.first().map(|value| table(name, value.clone()))).collect()
}
