//! What a description assumes is marked in the reference wherever that shows it: all that the base says is assumed at once.
//! What has no mark then must be what the reference does not show: without the editor's notes it is the same, whatever is
//! said there.

use devc::emit::markdown::Markdown;
use devc::emit::{Emitter, Options, emit};
use serde_json::Value;
use toml::Table;

use crate::places::{Place, places};
use crate::{outcome, samples};

/// The reference of a description, if it compiles.
fn reference(description: &Table, editorial: bool) -> Option<String> {
    let family = outcome(description).family?;
    let options = Options { editorial, ..Options::default() };
    let files = emit(&family, &[&Markdown as &dyn Emitter], &options);
    Some(files.text(".md").expect("a reference").to_owned())
}

/// Whether a link before the list of assumptions leads to the one with this reason.
fn is_marked(reference: &str, reason: &str) -> bool {
    let (body, lists) = reference.split_once("\n### Assumptions\n").expect("a list");
    let listed =
        lists.lines().find(|line| line.contains(reason)).unwrap_or_else(|| panic!("{reason} in no list"));
    let anchor = listed.split("<a id=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("an anchor");
    body.contains(&format!("](#{anchor})"))
}

/// Whether an output shows what a key says: it is another one if the key says something else, or nothing.
pub(crate) fn is_shown(
    base: &Table,
    (place, key): (&Place, &str),
    schema: &Value,
    show: impl Fn(&Table) -> Option<String>,
) -> bool {
    let plain = show(base).expect("the base compiles");
    let (_, holds) =
        place.keys(schema).into_iter().find(|(known, _)| known == key).expect("a key of the schema");
    let others = samples::samples(key, &holds, schema).into_iter();
    let others = others.filter_map(|other| place.with(base, key, other));
    let mut texts = others.chain(place.without(base, key)).filter_map(|other| show(&other));
    texts.any(|text| text != plain)
}

/// A description in which all that it says is assumed, and each fact with the reason for it.
pub(crate) fn all_assumed(base: &Table, schema: &Value) -> (Table, Vec<(Place, String, String)>) {
    let (mut assumed, mut facts) = (base.clone(), Vec::new());
    for place in places(base, schema) {
        let keys: Vec<String> = place.keys(schema).into_iter().map(|(key, _)| key).collect();
        let said = place.table(base).expect("a table of the base");
        let said = keys
            .iter()
            .filter(|key| said.contains_key(*key) && !matches!(key.as_str(), "source" | "entries"));
        if !keys.iter().any(|key| key == "assumed") {
            continue;
        }
        let mut reasons = Table::new();
        for key in said {
            let reason = format!("reason {} of many", facts.len());
            reasons.insert(key.clone(), reason.clone().into());
            facts.push((place.clone(), key.clone(), reason));
        }
        if !reasons.is_empty() {
            assumed =
                place.with(&assumed, "assumed", toml::Value::Table(reasons)).expect("nothing was assumed");
        }
    }
    (assumed, facts)
}

#[test]
fn what_is_assumed_is_marked_wherever_the_reference_shows_it() {
    let base: Table = toml::from_str(include_str!("base.toml")).expect("the base is TOML");
    let schema: Value = serde_json::from_str(&devc::raw::schema::schema()).expect("the schema is JSON");
    let (assumed, facts) = all_assumed(&base, &schema);
    assert!(facts.len() > 150, "only {} facts are assumed", facts.len());
    let marked = reference(&assumed, true).expect("what is assumed compiles");
    let missing = facts.iter().filter(|(_, _, reason)| !is_marked(&marked, reason));
    let missing =
        missing.filter(|(place, key, _)| is_shown(&base, (place, key), &schema, |one| reference(one, false)));
    let missing = missing.map(|(place, key, _)| format!("{place}.{key}"));
    let missing: Vec<String> = missing.collect();
    assert!(missing.is_empty(), "{} of {} have no mark: {missing:#?}", missing.len(), facts.len());
}
