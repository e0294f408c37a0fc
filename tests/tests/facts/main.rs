//! No written fact is lost: each key that the schema knows is set in each place that takes it, and then stands in the
//! JSON model, or a message says why not. And where it changes the model, the comparison of both versions tells it, once.

#![cfg(test)]

mod axes;
mod docs;
mod marks;
mod places;
mod samples;

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::LazyLock;
use std::thread;

use devc::diagnostic::{Diagnostics, Level};
use devc::diff::{Change, Class};
use devc::emit::{self, Emitter};
use devc::lint::{Checked, Levels};
use devc::model::Family;
use devc::source::Memory;
use serde_json::Value;
use toml::Table;

use places::Place;

/// What devc makes of a description: its model without what is said of the facts themselves, and its messages.
struct Outcome {
    family: Option<Checked<Family>>,
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
    let request = devc::Request { levels: levels(), ..devc::Request::default() };
    let compilation = devc::compile_with(&memory, Path::new("example"), &request, &mut |_| ());
    let model = compilation.family.as_ref().map(|family| {
        let json: &[&dyn Emitter] = &[&emit::json::Json];
        let files = emit::emit(family, json, &emit::Options::default());
        without_provenance(serde_json::from_str(files.text(".json").expect("the model")).expect("it is JSON"))
    });
    Outcome { family: compilation.family.clone(), model, messages: messages(&compilation.diagnostics) }
}

/// What comes of setting keys.
#[derive(Default)]
struct Found {
    tried: usize,
    /// The keys that leave no trace.
    lost: Vec<String>,
    /// The keys that change the model, and the comparison tells nothing or something twice.
    untold: Vec<String>,
    /// The keys whose change only people notice, where the names of things are `*`.
    documentation: BTreeSet<String>,
}

impl Found {
    fn add(&mut self, other: Self) {
        self.tried += other.tried;
        self.lost.extend(other.lost);
        self.untold.extend(other.untold);
        self.documentation.extend(other.documentation);
    }
}

/// Whether the comparison of two outcomes tells that something changes, and nothing twice.
fn is_told(before: &Outcome, after: &Outcome) -> bool {
    let (Some(old), Some(new)) = (&before.family, &after.family) else { return true };
    let changes = devc::diff::compare(old, new).changes;
    let is_twice =
        |(place, change): (usize, &Change)| changes.iter().skip(place + 1).any(|other| other == change);
    !changes.is_empty() && !changes.iter().enumerate().any(is_twice)
}

/// Whether the comparison of two outcomes tells what only people notice.
fn is_documentation(before: &Outcome, after: &Outcome) -> bool {
    let (Some(old), Some(new)) = (&before.family, &after.family) else { return false };
    let changes = devc::diff::compare(old, new).changes;
    !changes.is_empty() && changes.iter().all(|change| change.kind.class == Class::Documentation)
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

/// Sets every key of a description in every place.
fn set_everything(description: &str) -> Found {
    let base: Table = toml::from_str(description).expect("the base is TOML");
    let before = outcome(&base);
    assert!(before.model.is_some(), "the base compiles: {:#?}", before.messages);
    let schema: Value = serde_json::from_str(&devc::raw::schema::schema()).expect("the schema is JSON");
    let places = places::places(&base, &schema);
    let keys = places.iter().flat_map(|place| place.keys(&schema).into_iter().map(move |key| (place, key)));
    let keys: Vec<_> = keys.collect();
    let set = |place: &Place, key: &str, holds: &Value| {
        let mut found = Found { tried: 1, ..Found::default() };
        let changed =
            samples::samples(key, holds, &schema).into_iter().filter_map(|one| place.with(&base, key, one));
        let traced = changed.map(|changed| outcome(&changed)).find(|after| {
            after.model != before.model || after.messages.iter().any(|new| !before.messages.contains(new))
        });
        match traced {
            None => found.lost.push(format!("{place}.{key}")),
            Some(after) if after.model != before.model && !is_told(&before, &after) => {
                found.untold.push(format!("{place}.{key}"));
            }
            Some(after) if is_documentation(&before, &after) => {
                found.documentation.insert(format!("{}.{key}", place.kind()));
            }
            Some(_) => {}
        }
        found
    };
    let part = |keys: &[(&Place, (String, Value))]| -> Found {
        let mut all = Found::default();
        keys.iter().for_each(|(place, (key, holds))| all.add(set(place, key, holds)));
        all
    };
    let mut all = Found::default();
    thread::scope(|scope| {
        let parts = keys.chunks(keys.len().div_ceil(4)).map(|keys| scope.spawn(move || part(keys)));
        let parts: Vec<_> = parts.collect();
        parts.into_iter().for_each(|part| all.add(part.join().expect("it does not panic")));
    });
    all
}

fn judge(found: &Found, at_least: usize) {
    let Found { tried, lost, untold, .. } = found;
    assert!(*tried > at_least, "only {tried} keys were tried");
    assert!(lost.is_empty(), "{} of {tried} are lost:\n{}", lost.len(), lost.join("\n"));
    assert!(untold.is_empty(), "{} of {tried} are no change, or twice:\n{}", untold.len(), untold.join("\n"));
}

/// What comes of setting every key of the base.
static BASE: LazyLock<Found> = LazyLock::new(|| set_everything(include_str!("base.toml")));

#[test]
fn no_written_fact_is_lost() {
    judge(&BASE, 700);
}

/// A key is of the class that masters notice unless somebody decided that none does: those stand in a list.
#[test]
fn what_counts_as_documentation_was_decided() {
    let list = include_str!("documentation.txt").lines().map(str::trim);
    let decided: BTreeSet<String> =
        list.filter(|line| !line.is_empty() && !line.starts_with('#')).map(str::to_owned).collect();
    let new: Vec<&String> = BASE.documentation.difference(&decided).collect();
    assert!(new.is_empty(), "count as documentation, and nobody decided it: {new:#?}");
    let old: Vec<&String> = decided.difference(&BASE.documentation).collect();
    assert!(old.is_empty(), "stand in the list, and masters notice them, or they are gone: {old:#?}");
}

#[test]
fn no_fact_of_a_member_is_lost() {
    judge(&set_everything(include_str!("members.toml")), 60);
}

/// In each table that can give reasons, one for a key that is not there is answered, and one for each key that is there is
/// taken.
#[test]
fn what_is_assumed_is_a_fact() {
    let base: Table = toml::from_str(include_str!("base.toml")).expect("the base is TOML");
    let schema: Value = serde_json::from_str(&devc::raw::schema::schema()).expect("the schema is JSON");
    let places = places::places(&base, &schema);
    let can_assume: Vec<&Place> = places.iter().filter(|place| place.can_assume()).collect();
    assert!(can_assume.len() > 50, "{} tables can give reasons", can_assume.len());
    let assume = |keys: &dyn Fn(&Place) -> Vec<String>| {
        let with_reasons = can_assume.iter().fold(base.clone(), |all, place| {
            let reasons = keys(place).into_iter().map(|key| (key, "it is likely".into()));
            place.with(&all, "assumed", reasons.collect::<Table>().into()).expect("another table")
        });
        let messages = outcome(&with_reasons).messages.into_iter();
        messages.filter(|message| message.starts_with("idle-assumption")).collect::<Vec<_>>()
    };
    let found = assume(&|_| vec!["nonsense".to_owned()]);
    assert_eq!(found.len(), can_assume.len(), "{found:#?}");
    let found = assume(&|place| place.stated(&base));
    assert!(found.is_empty(), "{found:#?}");
}

/// What is compared is the same for the same description: a difference comes from what is set.
#[test]
fn the_same_description_has_the_same_outcome() {
    let base: Table = toml::from_str(include_str!("base.toml")).expect("the base is TOML");
    let (first, second) = (outcome(&base), outcome(&base));
    assert_eq!(first.model, second.model);
    assert_eq!(first.messages, second.messages);
}
