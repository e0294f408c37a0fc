//! The reference of the format for people: the schema as tables, behind an introduction.

use std::collections::BTreeMap;

use serde_json::Value;

use super::section::all;
use super::tidy::without_null;
use crate::model::{SYMBOLS, Shape};

const INTRODUCTION: &str = include_str!("introduction.md");

/// The reference of the format, in Markdown.
pub fn reference() -> String {
    let mut generator = super::generator();
    let tables: Vec<(&str, Shape, Value)> =
        all().map(|(name, shape, table)| (name, shape, table(&mut generator))).collect();
    let inner: BTreeMap<String, Value> = generator.take_definitions(false).into_iter().collect();

    let mut text = INTRODUCTION.to_owned();
    text.push_str("\n## Sections\n\n");
    for (name, shape, table) in &tables {
        text.push_str(&format!("- [`{}`](#{name})\n", heading(name, *shape, table)));
    }
    for (name, shape, table) in &tables {
        text.push_str(&format!("\n### <a id=\"{name}\"></a>`{}`\n\n", heading(name, *shape, table)));
        text.push_str(&format!("{}\n\n{}", about(table), keys(table)));
    }
    text.push_str("\n## Tables within tables\n\nThe reference names them where a key holds one.\n");
    for (name, schema) in inner.iter().filter(|(_, schema)| table_of(schema).is_some()) {
        text.push_str(&format!("\n### <a id=\"{}\"></a>{}\n\n", anchor(name), title(name)));
        text.push_str(&format!("{}\n\n", about(schema)));
        text.push_str(&table_of(schema).map_or(String::new(), keys));
    }
    text.push_str("\n## Words to choose from\n");
    for (name, schema) in inner.iter().filter(|(_, schema)| schema.get("oneOf").is_some()) {
        text.push_str(&format!("\n### <a id=\"{}\"></a>{}\n\n", anchor(name), title(name)));
        text.push_str(&format!("{}\n\n{}", about(schema), words(schema)));
    }
    text.push_str(&symbols());
    text
}

/// The symbols of units that generated code has types for, by what they measure.
fn symbols() -> String {
    let mut text = "\n### <a id=\"symbols\"></a>symbols\n\n".to_owned();
    text.push_str("What the symbols of units measure. Generated code converts values with these symbols; with any other\n");
    text.push_str("it counts steps of the device's own.\n\n| Measures | Symbols |\n| --- | --- |\n");
    for of_one in SYMBOLS.chunk_by(|one, next| one.dimension == next.dimension) {
        let measures = of_one.first().map(|symbol| title(&format!("{:?}", symbol.dimension)));
        let symbols: Vec<String> = of_one.iter().map(|symbol| format!("`{}`", symbol.text)).collect();
        text.push_str(&format!("| {} | {} |\n", measures.unwrap_or_default(), symbols.join(", ")));
    }
    text
}

/// How the header of a table in the section is written: as its documentation has it.
fn heading(section: &str, shape: Shape, table: &Value) -> String {
    let about = table.get("description").and_then(Value::as_str).unwrap_or_default();
    let headers = about.split('`').skip(1).step_by(2);
    let named = |header: &&str| {
        let name = header.trim_matches(['[', ']']);
        name.split('.').next() == Some(section)
    };
    let plain = match shape {
        Shape::Single => format!("[{section}]"),
        Shape::Words | Shape::Numbers | Shape::Indices => format!("[{section}.<key>]"),
        Shape::List => format!("[[{section}]]"),
    };
    headers.clone().find(named).map_or(plain, str::to_owned)
}

/// The keys of a table.
fn keys(table: &Value) -> String {
    let Some(Value::Object(properties)) = table.get("properties") else {
        let values = table.get("additionalProperties").map_or(String::new(), kind);
        return format!("Any key: {values}.\n");
    };
    let required = table.get("required").and_then(Value::as_array);
    let required = |key: &str| required.is_some_and(|keys| keys.iter().any(|one| one == key));
    let mut text = String::from("| Key | Holds | Needed | Meaning |\n| --- | --- | --- | --- |\n");
    // What every table can say of itself is in the introduction.
    let common = ["source", "assumed", "like", "without"];
    for (key, schema) in properties.iter().filter(|(key, _)| !common.contains(&key.as_str())) {
        let needed = if required(key) { "yes" } else { "" };
        text.push_str(&format!("| `{key}` | {} | {needed} | {} |\n", kind(schema), about(schema)));
    }
    text
}

/// Words with what each means.
fn words(schema: &Value) -> String {
    let words = schema.get("oneOf").and_then(Value::as_array).into_iter().flatten();
    let lines = words.map(|word| {
        let name = word.get("const").and_then(Value::as_str).unwrap_or_default();
        format!("- `\"{name}\"`: {}\n", about(word))
    });
    lines.collect()
}

/// What a key holds.
fn kind(schema: &Value) -> String {
    let mut schema = schema.clone();
    without_null(&mut schema);
    if let Some(name) = schema.get("$ref").and_then(Value::as_str).and_then(|path| path.rsplit('/').next()) {
        return format!("[{}](#{})", title(name), anchor(name));
    }
    if let Some(choices) = schema.get("anyOf").and_then(Value::as_array) {
        return choices.iter().map(kind).collect::<Vec<_>>().join(" or ");
    }
    match schema.get("type") {
        Some(Value::String(name)) => named(name, &schema),
        Some(Value::Array(names)) => {
            let names = names.iter().filter_map(Value::as_str).map(|name| named(name, &schema));
            names.collect::<Vec<_>>().join(" or ")
        }
        _ => "any value".into(),
    }
}

/// A type of JSON in the words of this reference.
fn named(name: &str, schema: &Value) -> String {
    let inner = |key: &str| schema.get(key).filter(|inner| inner.is_object()).map(kind);
    match name {
        "string" => "text".into(),
        "boolean" => "`true` or `false`".into(),
        "integer" => format!("whole number{}", range(schema)),
        "array" => inner("items").map_or_else(|| "list".into(), |items| format!("list: {items}")),
        "object" if schema.get("properties").is_some() => "table".into(),
        "object" => {
            inner("additionalProperties").map_or_else(|| "table".into(), |of| format!("by key: {of}"))
        }
        other => other.to_owned(),
    }
}

/// The least and the greatest number of an integer of so many bits.
fn range(schema: &Value) -> String {
    match schema.get("format").and_then(Value::as_str) {
        Some("uint8") => ", 8 bits".into(),
        Some("uint16") => ", 16 bits".into(),
        Some("uint32") => ", 32 bits".into(),
        Some("int8") => ", 8 bits, signed".into(),
        Some("int16") => ", 16 bits, signed".into(),
        _ => String::new(),
    }
}

/// The documentation of a schema, on one line and with links as words.
fn about(schema: &Value) -> String {
    let text = schema.get("description").and_then(Value::as_str).unwrap_or_default();
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    // `[x]: what it is` stands under a heading that has the `[x]` already.
    let line = match line.split_once("]`: ") {
        Some((header, rest)) if header.starts_with("`[") => capital(rest),
        _ => line,
    };
    line.replace("[`", "`").replace("`]", "`").replace('|', "\\|")
}

fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or(String::new(), |first| first.to_uppercase().chain(chars).collect())
}

/// The keys of a definition, if it is a table or may be one.
fn table_of(schema: &Value) -> Option<&Value> {
    let choices = schema.get("anyOf").and_then(Value::as_array);
    let mut all = [schema].into_iter().chain(choices.into_iter().flatten());
    all.find(|one| one.get("properties").is_some())
}

/// The name of a struct as people read it: `RawMotionCommand` is a motion command.
fn title(name: &str) -> String {
    let mut title = String::new();
    for c in name.trim_start_matches("Raw").chars() {
        if c.is_uppercase() && !title.is_empty() {
            title.push(' ');
        }
        title.extend(c.to_lowercase());
    }
    title
}

fn anchor(name: &str) -> String {
    format!("table-{}", title(name).replace(' ', "-"))
}
