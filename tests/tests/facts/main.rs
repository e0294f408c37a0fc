//! No written fact is lost: each key that the schema knows is set in each place that takes it, and then stands in the
//! JSON model, or a message says why not.

#![cfg(test)]

mod places;
mod samples;

use std::path::Path;
use std::thread;

use devc::diagnostic::{Diagnostics, Level};
use devc::emit::{self, Emitter};
use devc::lint::Levels;
use devc::source::Memory;
use serde_json::Value;
use toml::Table;

use places::Place;

/// What devc makes of a description: its model without what is said of the facts themselves, and its messages.
struct Outcome {
    model: Option<Value>,
    messages: Vec<String>,
}

/// Every rule at the level of a warning, so that the model is made.
fn levels() -> Levels {
    let mut levels = Levels::default();
    for group in devc::diagnostic::Group::ALL {
        levels.set(group.name(), Level::Warning, None);
    }
    levels
}

fn outcome(description: &Table) -> Outcome {
    let text = toml::to_string(description).expect("a table is TOML");
    let memory = Memory::default().with("example/device.toml", text.into_bytes());
    let compilation = devc::compile_with(&memory, Path::new("example"), &levels(), &mut |_| ());
    let model = compilation.family.as_ref().map(|family| {
        let json: &[&dyn Emitter] = &[&emit::json::Json];
        let files = emit::emit(family, json, &emit::Options::default());
        let text = files.0.values().next().expect("one output").clone();
        without_provenance(serde_json::from_str(&text).expect("it is JSON"))
    });
    Outcome { model, messages: messages(&compilation.diagnostics) }
}

fn messages(diagnostics: &Diagnostics) -> Vec<String> {
    diagnostics.iter().map(|message| format!("{}: {}", message.rule.name, message.message)).collect()
}

/// The model without the register of who says what: a fact is not kept by being listed there.
fn without_provenance(mut value: Value) -> Value {
    match &mut value {
        Value::Object(members) => {
            members.remove("provenance");
            members.values_mut().for_each(|value| *value = without_provenance(value.take()));
        }
        Value::Array(items) => items.iter_mut().for_each(|value| *value = without_provenance(value.take())),
        _ => {}
    }
    value
}

/// The keys of a description that can be set without a trace, and how many were tried.
fn lost(description: &str) -> (Vec<String>, usize) {
    let base: Table = toml::from_str(description).expect("the base is TOML");
    let before = outcome(&base);
    assert!(before.model.is_some(), "the base compiles: {:#?}", before.messages);
    let schema: Value = serde_json::from_str(&devc::raw::schema::schema()).expect("the schema is JSON");
    let places = places::places(&base, &schema);
    let keys = places.iter().flat_map(|place| place.keys(&schema).into_iter().map(move |key| (place, key)));
    let keys: Vec<_> = keys.collect();
    let is_lost = |place: &Place, key: &str, holds: &Value| {
        !samples::samples(key, holds, &schema).into_iter().any(|sample| {
            let Some(changed) = place.with(&base, key, sample) else { return false };
            let after = outcome(&changed);
            after.model != before.model || after.messages.iter().any(|new| !before.messages.contains(new))
        })
    };
    let part = |keys: &[(&Place, (String, Value))]| -> Vec<String> {
        let lost = keys.iter().filter(|(place, (key, holds))| is_lost(place, key, holds));
        lost.map(|(place, (key, _))| format!("{place}.{key}")).collect()
    };
    let found = thread::scope(|scope| {
        let parts = keys.chunks(keys.len().div_ceil(4)).map(|keys| scope.spawn(move || part(keys)));
        let parts: Vec<_> = parts.collect();
        parts.into_iter().flat_map(|part| part.join().expect("it does not panic")).collect()
    });
    (found, keys.len())
}

#[test]
fn no_written_fact_is_lost() {
    let (lost, tried) = lost(include_str!("base.toml"));
    assert!(tried > 700, "only {tried} keys were tried");
    assert!(lost.is_empty(), "{} of {tried} are lost:\n{}", lost.len(), lost.join("\n"));
}

#[test]
fn no_fact_of_a_member_is_lost() {
    let (lost, tried) = lost(include_str!("members.toml"));
    assert!(tried > 60, "only {tried} keys were tried");
    assert!(lost.is_empty(), "{} of {tried} are lost:\n{}", lost.len(), lost.join("\n"));
}

/// What is compared is the same for the same description: a difference comes from what is set.
#[test]
fn the_same_description_has_the_same_outcome() {
    let base: Table = toml::from_str(include_str!("base.toml")).expect("the base is TOML");
    let (first, second) = (outcome(&base), outcome(&base));
    assert_eq!(first.model, second.model);
    assert_eq!(first.messages, second.messages);
}
