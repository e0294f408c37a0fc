//! One word, one meaning: each closed word of the format, set in a description, and what each output makes of it.
//!
//! `words.toml` has the words of the schema with the meaning that a standard gives them in each output. A meaning has to be
//! there with its word and not with another one, so that no two outputs take a word differently.

#![cfg(test)]

use std::collections::BTreeMap;
use std::path::Path;

use devc::diagnostic::{Group, Level};
use devc::emit::{self, Options};
use devc::lint::Levels;
use devc::source::Memory;
use serde_json::Value as Json;
use toml::{Table, Value};

/// The outputs by the ending of their files.
const OUTPUTS: [(&str, &str); 4] = [("esi", "xml"), ("markdown", "md"), ("rust", "rs"), ("json", "json")];

/// Closed words that are about devc and not about a device.
const ABOUT_DEVC: &[&str] = &["level"];

/// Words that the base cannot have: an object with entries is no single value.
const IMPOSSIBLE: &[(&str, &str)] = &[("kind", "var")];

/// The outputs of a description, by name.
type Outputs = BTreeMap<&'static str, String>;

fn meanings() -> Table {
    toml::from_str(include_str!("words.toml")).expect("the meanings are TOML")
}

/// The base with a word at a place.
fn with(word: &str, at: &[&str]) -> Table {
    let mut base: Table = toml::from_str(include_str!("../facts/base.toml")).expect("the base is TOML");
    let (first, rest) = at.split_first().expect("a place");
    let top = base.entry(*first).or_insert_with(|| Value::Table(Table::new()));
    set(top, rest, word);
    base
}

fn set(value: &mut Value, at: &[&str], word: &str) {
    let Some((key, rest)) = at.split_first() else {
        *value = word.into();
        return;
    };
    if let Ok(place) = key.parse::<usize>()
        && (value.is_array() || rest.is_empty())
    {
        if !value.is_array() {
            *value = Value::Array(vec![word.into()]);
        }
        return set(&mut value.as_array_mut().expect("a list")[place], rest, word);
    }
    let inner = value.as_table_mut().expect("a table").entry(*key);
    set(inner.or_insert_with(|| Value::Table(Table::new())), rest, word);
}

fn outputs(description: &Table) -> Outputs {
    let text = toml::to_string(description).expect("a table is TOML");
    let memory = Memory::default().with("example/device.toml", text.into_bytes());
    let mut levels = Levels::default();
    Group::ALL.iter().for_each(|group| levels.set(group.name(), Level::Allow, None));
    let request = devc::Request { levels, ..devc::Request::default() };
    let compilation = devc::compile_with(&memory, Path::new("example"), &request, &mut |_| ());
    let Some(family) = &compilation.family else {
        let messages: Vec<_> = compilation.diagnostics.iter().map(|one| one.message.clone()).collect();
        panic!("{messages:#?}");
    };
    let files = emit::emit(family, emit::ALL, &Options::default()).0;
    let output = |(name, ending): &(&'static str, &str)| {
        let (_, text) = files.iter().find(|(file, _)| file.ends_with(ending)).expect("the output");
        (*name, String::from_utf8(text.clone()).expect("text"))
    };
    OUTPUTS.iter().map(output).collect()
}

/// The words of a choice with what they mean.
fn words(choice: &Table) -> impl Iterator<Item = (&str, &Table)> {
    choice.iter().filter_map(|(word, meaning)| Some((word.as_str(), meaning.as_table()?)))
}

/// What is not as `words.toml` has it.
fn faults(name: &str, choice: &Table) -> Vec<String> {
    let at = choice["at"].as_array().expect("a place");
    let at: Vec<&str> = at.iter().filter_map(Value::as_str).collect();
    let made: BTreeMap<&str, Outputs> =
        words(choice).map(|(word, _)| (word, outputs(&with(word, &at)))).collect();
    let mut faults = Vec::new();
    for (word, meaning) in words(choice) {
        for (output, expected) in meaning {
            let expected = expected.as_str().expect("a piece of an output");
            let times = |word: &str| made[word][output.as_str()].matches(expected).count();
            let means_else = words(choice).filter(|(_, other)| other.get(output) != meaning.get(output));
            let not_more = means_else.map(|(other, _)| other).filter(|other| times(other) >= times(word));
            let not_more: Vec<&str> = not_more.collect();
            if times(word) == 0 {
                faults.push(format!("{name} `{word}`: {output} has no `{expected}`"));
            } else if !not_more.is_empty() {
                faults.push(format!("{name} {not_more:?}: {output} has `{expected}` as with `{word}`"));
            }
        }
    }
    faults
}

#[test]
fn each_word_has_its_meaning_in_each_output() {
    let faults: Vec<String> = meanings()
        .iter()
        .flat_map(|(name, choice)| faults(name, choice.as_table().expect("a choice")))
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_closed_word_is_asked() {
    let schema: Json = serde_json::from_str(&devc::raw::schema::schema()).expect("the schema is JSON");
    let meanings = meanings();
    let mut unasked = Vec::new();
    for (name, definition) in schema["$defs"].as_object().expect("definitions") {
        let Some(choices) = definition["oneOf"].as_array() else { continue };
        let name = kebab(name);
        for word in choices.iter().filter_map(|choice| choice["const"].as_str()) {
            let is_asked = meanings.get(&name).is_some_and(|choice| choice.get(word).is_some());
            let is_excused =
                ABOUT_DEVC.contains(&name.as_str()) || IMPOSSIBLE.contains(&(name.as_str(), word));
            if is_asked == is_excused {
                unasked.push(format!("{name} `{word}`"));
            }
        }
    }
    assert!(
        unasked.is_empty(),
        "nobody asks what these mean, or excuses them in vain: {}",
        unasked.join(", ")
    );
}

/// `WriteWindow` as `write-window`.
fn kebab(name: &str) -> String {
    let mut kebab = String::new();
    for c in name.chars() {
        if c.is_uppercase() && !kebab.is_empty() {
            kebab.push('-');
        }
        kebab.extend(c.to_lowercase());
    }
    kebab
}
