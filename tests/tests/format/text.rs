//! What no text may hold is refused in every place of a description that takes text, as the schema lists them.

use std::collections::BTreeSet;
use std::path::Path;

use devc::raw::schema::schema;
use devc::source::Memory;
use serde_json::Value;

/// One character of each kind that no text may hold.
const HAZARDS: [char; 12] = [
    '\0',
    '\u{1B}',
    '\r',
    '\u{7F}',
    '\u{9B}',
    '\u{2028}',
    '\u{202E}',
    '\u{200F}',
    '\u{AD}',
    '\u{FEFF}',
    '\u{FFFE}',
    '\u{E0041}',
];

/// A step from a table or a list to what is in it.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Step {
    Key(String),
    /// Any key: a name or a number of the description's own.
    Any,
    Item,
}

/// The paths to all that can be a text, and to all keys that are free.
fn places(schema: &Value, at: &Value, path: &mut Vec<Step>, found: &mut BTreeSet<Vec<Step>>) {
    // values can have values, and members have all sections again
    if path.len() > 9 || path.iter().filter(|step| **step == Step::Key("values".to_owned())).count() > 2 {
        return;
    }
    if let Some(reference) = at["$ref"].as_str() {
        return places(schema, schema.pointer(&reference[1..]).expect("it is defined"), path, found);
    }
    for choice in ["anyOf", "oneOf", "allOf"].iter().filter_map(|key| at[key].as_array()).flatten() {
        places(schema, choice, path, found);
    }
    let types = |name: &str| {
        at["type"] == name || at["type"].as_array().is_some_and(|all| all.contains(&name.into()))
    };
    if types("string") || at["const"].is_string() || at["enum"].is_array() {
        found.insert(path.clone());
    }
    let mut within = |step, inner: &Value| {
        path.push(step);
        places(schema, inner, path, found);
        path.pop();
    };
    for (key, inner) in at["properties"].as_object().into_iter().flatten() {
        within(Step::Key(key.clone()), inner);
    }
    if at["items"].is_object() {
        within(Step::Item, &at["items"]);
    }
    for free in
        ["additionalProperties", "patternProperties"].iter().map(|key| &at[key]).filter(|it| it.is_object())
    {
        within(Step::Any, free);
    }
}

/// A description with a text at a path, as TOML on one line; the keys that are free have `key` at their end.
fn description(path: &[Step], text: &str, key: &str) -> String {
    let Some((first, rest)) = path.split_first() else { return format!("\"{text}\"") };
    let inner = description(rest, text, key);
    match first {
        Step::Key(name) => format!("{{ {name} = {inner} }}"),
        Step::Any => format!("{{ \"1{key}\" = {inner} }}"),
        Step::Item => format!("[{inner}]"),
    }
}

/// A file: the outermost table without its braces.
fn file(path: &[Step], text: &str, key: &str) -> String {
    let table = description(path, text, key);
    table.strip_prefix("{ ").and_then(|it| it.strip_suffix(" }")).expect("a table").to_owned() + "\n"
}

/// Where characters are refused in a file.
fn refused(text: &str) -> Vec<usize> {
    let compilation = devc::compile(&Memory::new().with("drive/device.toml", text), Path::new("drive"));
    let refused = compilation.diagnostics.iter().filter(|it| it.rule.name == "forbidden-character");
    refused.map(|it| it.at().expect("a place").start as usize).collect()
}

#[test]
fn every_place_refuses_what_no_text_may_hold() {
    let schema: Value = serde_json::from_str(&schema()).expect("the schema is JSON");
    let mut found = BTreeSet::new();
    places(&schema, &schema, &mut Vec::new(), &mut found);
    assert!(found.len() > 400, "the schema has only {} texts", found.len());
    for path in &found {
        for c in HAZARDS {
            let escape = format!("\\U{:08X}", u32::from(c));
            let in_text = file(path, &format!("a{escape}b"), "");
            let at = in_text.find('\\').expect("the escape");
            assert_eq!(refused(&in_text), [at], "U+{:04X} in {in_text}", u32::from(c));
        }
        if path.contains(&Step::Any) {
            let in_key = file(path, "a", "\\n");
            let all: Vec<usize> = in_key.match_indices('\\').map(|(at, _)| at).collect();
            assert_eq!(refused(&in_key), all, "{in_key}");
        }
    }
}

/// Those of ASCII are refused by TOML itself.
#[test]
fn what_is_written_as_it_is_is_refused_anywhere_in_a_file() {
    for c in HAZARDS.into_iter().filter(|c| !c.is_ascii()) {
        for text in [
            format!("# a{c}b\n"),
            format!("x = 'a{c}b'\n"),
            format!("'a{c}b' = 1\n"),
            format!("x = \"\"\"\na{c}b\"\"\"\n"),
        ] {
            assert_eq!(refused(&text), [text.find(c).expect("it is there")], "{text:?}");
        }
    }
}

#[test]
fn windows_and_a_mark_at_the_front_are_fine() {
    assert!(refused("\u{FEFF}x = \"\"\"\r\na\r\nb\"\"\"\r\n# c\r\n").is_empty());
}
