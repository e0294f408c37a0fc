//! Each thing that no source states as it stands here has a mark where it stands, whose link leads to the reason or the
//! erratum. The reader of the text knows what a person can see, and of the JSON the lists and names only.

mod place;
mod text;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use devc::emit::Options;
use devc::emit::json::Json;
use devc::emit::markdown::Markdown;
use devc::emit::{Emitter, emit};
use devc::source::Disk;
use serde_json::Value;

use place::Place;
use text::Text;

/// The descriptions that are shipped, and one that the tests have.
fn folders() -> Vec<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("devices/sv660n");
    crate::folders().into_iter().chain([own]).collect()
}

/// A description as text and as JSON.
fn outputs(folder: &Path, editorial: bool) -> (String, Value) {
    let family = devc::compile(&Disk, folder).family.unwrap_or_else(|| panic!("{}", folder.display()));
    let options = Options { editorial, ..Options::default() };
    let files = emit(&family, &[&Markdown as &dyn Emitter, &Json], &options);
    let text = files.text(".md").expect("a reference").to_owned();
    (text, serde_json::from_str(files.text(".json").expect("a model")).expect("JSON"))
}

/// What a list has of a thing: where it stands, and what tells its row from others about the same.
fn listed(member: &Value) -> Vec<(&str, Option<&str>)> {
    let errata = member["errata"].as_array().unwrap().iter();
    let errata = errata.filter(|erratum| {
        // What stands is what the source states. Where it says nothing and nobody knows better, there is no fact.
        let is_silent = erratum["says"].as_object().is_some_and(|says| says.is_empty());
        !(erratum["stands"].as_bool().unwrap() || is_silent && erratum["holds"].is_null())
    });
    let errata = errata.map(|erratum| (erratum["at"].as_str().unwrap(), erratum["rule"].as_str()));
    let assumptions = member["assumptions"].as_array().unwrap().iter();
    errata.chain(assumptions.map(|assumption| (assumption["at"].as_str().unwrap(), None))).collect()
}

#[test]
fn what_no_source_states_is_marked_where_it_stands() {
    let mut missing = Vec::new();
    for folder in folders() {
        let (markdown, json) = outputs(&folder, true);
        let text = Text::read(&markdown);
        for member in json["members"].as_array().unwrap() {
            // an erratum of a family is listed for members that lack the object, too
            // and a device with one axis has no chapter about that
            let is_there = |at: &str| match at.starts_with("axes.") {
                true => member["axes"].as_array().unwrap().len() > 1,
                false => !place::things(at, member).is_empty(),
            };
            let listed = listed(member).into_iter().filter(|(at, _)| is_there(at));
            for (at, rule) in listed {
                let anchor = text.anchor(at, rule);
                let place = Place::read(at, member);
                let marks: Vec<_> = text.lines_to(&anchor).collect();
                let is_there = marks.iter().any(|line| place.is_told_by(line));
                if !is_there {
                    let lines: Vec<_> = marks.iter().map(|line| line.all()).collect();
                    missing.push(format!(
                        "{}: {at} {} {lines:.400?}",
                        member["id"],
                        rule.unwrap_or("assumed")
                    ));
                }
            }
        }
    }
    missing.dedup();
    assert!(missing.is_empty(), "{} without a mark at their place: {missing:#?}", missing.len());
}

/// The lists of JSON and what it says of each fact are one.
#[test]
fn what_is_assumed_is_assumed_where_json_says_who_says_it() {
    let mut missing = Vec::new();
    for folder in folders() {
        let (_, json) = outputs(&folder, true);
        for member in json["members"].as_array().unwrap() {
            for assumption in member["assumptions"].as_array().unwrap() {
                let (at, reason) =
                    (assumption["at"].as_str().unwrap(), assumption["reason"].as_str().unwrap());
                let found = place::things(at, member).iter().any(|thing| says(thing, reason));
                if !found && !missing.contains(&at.to_owned()) {
                    missing.push(at.to_owned());
                }
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// What an erratum answers is in JSON what it corrects, or contradicts: what it takes away and what stands in lists, too. Not
/// each member of a family has it.
#[test]
fn what_an_erratum_answers_is_answered_where_json_says_who_says_it() {
    for folder in folders() {
        let (_, json) = outputs(&folder, true);
        let (mut all, mut answered) = (BTreeSet::new(), BTreeSet::new());
        for member in json["members"].as_array().unwrap() {
            let listed = listed(member);
            for (number, erratum) in member["errata"].as_array().unwrap().iter().enumerate() {
                let (at, rule) = (erratum["at"].as_str().unwrap(), erratum["rule"].as_str());
                if listed.contains(&(at, rule)) {
                    all.insert((at, rule));
                    let is_said = place::things(at, member).iter().any(|thing| answers(thing, number));
                    answered.extend(is_said.then_some((at, rule)));
                }
            }
        }
        let silent: Vec<_> = all.difference(&answered).collect();
        assert!(silent.is_empty(), "{}: {silent:?}", folder.display());
    }
}

/// Whether an erratum of this number answers a fact in it.
fn answers(value: &Value, number: usize) -> bool {
    match value {
        Value::Object(members) => members.iter().any(|(key, value)| match key.as_str() {
            "contradicted" | "corrected" => value == number,
            _ => answers(value, number),
        }),
        Value::Array(items) => items.iter().any(|item| answers(item, number)),
        _ => false,
    }
}

/// Whether a fact in it is assumed for this reason, or an erratum answers it although it is.
fn says(value: &Value, reason: &str) -> bool {
    match value {
        Value::Object(members) => members.iter().any(|(key, value)| match key.as_str() {
            "assumed" => value == reason,
            "contradicted" | "corrected" => true,
            _ => says(value, reason),
        }),
        Value::Array(items) => items.iter().any(|item| says(item, reason)),
        _ => false,
    }
}

/// A vendor's customers get the facts alone.
#[test]
fn without_the_editors_notes_no_mark_is_left() {
    for folder in folders() {
        let (plain, _) = outputs(&folder, false);
        for trace in
            ["†", "‡", "#assumed-", "#erratum-", "<a id=\"assumed-", "<a id=\"erratum-", "profile:", "<sup>"]
        {
            let line = plain.lines().find(|line| line.contains(trace));
            assert_eq!(line, None, "{}: {trace}", folder.display());
        }
        for word in ["assumed", "corrected", "contradicted"] {
            let marks = plain
                .lines()
                .filter(|line| line.contains(&format!("[{word}]")) || line.contains(&format!("{word}: [")));
            assert_eq!(marks.count(), 0, "{}: {word}", folder.display());
        }
        let is_there = |link: &str| plain.contains(&format!("<a id=\"{link}\">"));
        for link in crate::between(&plain, "](#", ')') {
            assert!(is_there(link), "{}: nothing at #{link}", folder.display());
        }
    }
}
