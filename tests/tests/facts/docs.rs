//! What no source states is told in the documentation of the Rust that has it.

use std::path::Path;

use devc::emit::rust::Rust;
use devc::emit::{Emitter, Options, emit};
use devc::lint::Checked;
use devc::model::{Family, Object};
use devc::source::Disk;
use serde_json::Value;
use toml::Table;

use crate::marks::{all_assumed, is_shown};
use crate::outcome;
use crate::places::Place;

fn rust(family: &Checked<Family>) -> String {
    let files = emit(family, &[&Rust as &dyn Emitter], &Options::default());
    files.text(".rs").expect("Rust").to_owned()
}

/// The letters and digits of a text: lines are wrapped, and some characters escaped.
fn letters(text: &str) -> String {
    text.chars().filter(|c| c.is_alphanumeric()).collect()
}

/// The documentation in Rust.
fn documentation(rust: &str) -> String {
    let lines = rust.lines().map(str::trim_start);
    letters(
        &lines.filter_map(|line| line.strip_prefix("///").or(line.strip_prefix("//!"))).collect::<String>(),
    )
}

#[test]
fn what_devices_assume_and_errata_answer_is_told() {
    let mut missing = Vec::new();
    for device in ["c887", "s700", "pmc-sc6"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(device);
        let family = devc::compile(&Disk, &folder).family.expect("it compiles");
        let told = documentation(&rust(&family));
        let mut tried = 0;
        for member in &family.members {
            let errata = member.errata.iter().filter(|erratum| !erratum.stands);
            let errata = errata.map(|erratum| (erratum.at.to_string(), &erratum.why));
            let assumptions = member.assumptions.iter().map(|one| (one.at.to_string(), &one.reason));
            // the name and the kind of an object are there once, for all axes: those of the first
            let is_there = |at: &str| {
                let index = at.strip_prefix("0x").and_then(|at| u16::from_str_radix(at.get(..4)?, 16).ok());
                let is_object =
                    |object: &Object| Some(object.index.0) == index && object.leading == object.index;
                let has_pdo = member.pdos.iter().any(|pdo| Some(pdo.index.0) == index);
                index.is_some() && (at.len() > 6 || has_pdo || member.objects.iter().any(is_object))
            };
            for (at, reason) in assumptions.chain(errata).filter(|(at, _)| is_there(at)) {
                tried += 1;
                if !told.contains(&letters(reason)) {
                    missing.push(format!("{device} {at}: {reason}"));
                }
            }
        }
        assert!(tried > 10, "{device}: only {tried}");
    }
    missing.dedup();
    assert!(missing.is_empty(), "{missing:#?}");
}

/// What Rust has no place for: it names documents only where facts are from them.
const OTHERS: &[&str] = &["documents", "errata"];

#[test]
fn what_is_assumed_is_told_wherever_rust_has_it() {
    let base: Table = toml::from_str(include_str!("base.toml")).expect("the base is TOML");
    let schema: Value = serde_json::from_str(&devc::raw::schema::schema()).expect("the schema is JSON");
    let show = |description: &Table| outcome(description).family.map(|family| rust(&family));
    let (assumed, facts) = all_assumed(&base, &schema);
    let told = documentation(&show(&assumed).expect("what is assumed compiles"));
    let has_docs = |place: &Place| !OTHERS.iter().any(|other| place.to_string().starts_with(other));
    let facts: Vec<_> = facts.into_iter().filter(|(place, ..)| has_docs(place)).collect();
    assert!(facts.len() > 120, "only {} facts are assumed", facts.len());
    let missing = facts.iter().filter(|(_, _, reason)| !told.contains(&letters(reason)));
    let missing = missing.filter(|(place, key, _)| is_shown(&base, (place, key), &schema, show));
    let missing: Vec<String> = missing.map(|(place, key, _)| format!("{place}.{key}")).collect();
    assert!(missing.is_empty(), "{} of {}: {missing:#?}", missing.len(), facts.len());
}
