//! What an erratum says of how things are on axes is answered where the fact stands.

use devc::emit::json::Json;
use devc::emit::markdown::Markdown;
use devc::emit::{Emitter, Options, emit};
use serde_json::Value;
use toml::Table;

use crate::outcome;

/// The base with one of each thing that says how it is on axes, and one more erratum. The base has one already.
fn with_erratum(at: &str, keys: &str) -> Table {
    let base = include_str!("base.toml").replace("[rx-pdos.0x1600]\n", "[rx-pdos.0x1600]\nper-axis = true\n");
    let erratum = format!(
        "[[errata]]\nrule = \"contradicted-quantity\"\nat = \"{at}\"\nwhy = \"It was measured.\"\n{keys}\n"
    );
    toml::from_str(&format!("{base}\n{erratum}")).expect("it is TOML")
}

/// Who says each fact of a thing, by its key.
fn provenances<'j>(part: &'j Value, found: &mut Vec<(&'j str, &'j Value)>) {
    match part {
        Value::Object(members) => {
            let own = members.get("provenance").and_then(Value::as_object).into_iter().flatten();
            found.extend(own.map(|(key, who)| (key.as_str(), who)));
            members.values().for_each(|member| provenances(member, found));
        }
        Value::Array(items) => items.iter().for_each(|item| provenances(item, found)),
        _ => {}
    }
}

#[test]
fn what_is_said_of_axes_has_its_erratum() {
    for (section, at, keys, key, who) in [
        (
            "units",
            "units.speed",
            "says = { per-axis = { B = { symbol = \"mm/s\" } } }\nholds = { per-axis = { B = { symbol = \"mm\" } } }",
            "per_axis",
            "corrected",
        ),
        ("units", "units.speed.per-axis.B", "says = { symbol = \"mm/s\" }", "per_axis", "contradicted"),
        ("pdos", "0x1600", "says = { per-axis = true }", "per_axis", "contradicted"),
        ("objects", "0x2900", "says = { max = 9 }\nholds = { max = 8 }", "max", "corrected"),
    ] {
        let after = outcome(&with_erratum(at, keys));
        let family = after.family.unwrap_or_else(|| panic!("{at}: {:#?}", after.messages));
        let files = emit(&family, &[&Markdown as &dyn Emitter, &Json], &Options::default());
        let json: Value = serde_json::from_str(files.text(".json").expect("a model")).expect("it is JSON");
        let mut found = Vec::new();
        provenances(&json["members"][0][section], &mut found);
        let answered: Vec<_> = found.iter().filter(|(_, by)| by[who] == 1).map(|(key, _)| *key).collect();
        assert!(answered.contains(&key), "{at}: {answered:?}");
        let text = files.text(".md").expect("a reference");
        let (body, lists) = text.split_once("\n### Errata").expect("a list");
        let listed = lists.lines().find(|line| line.contains("It was measured.")).expect("it is listed");
        let anchor =
            listed.split("<a id=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("an anchor");
        assert!(body.contains(&format!("](#{anchor})")), "{at} has no mark");
    }
}
