//! Whoever reads the vendor's name of a parameter gets to where it is described.

use std::collections::BTreeSet;

use devc::model::Family;

use crate::{between, described, references};

/// The names of all parameters of a family, from a row of their own or an object.
fn names(family: &Family) -> BTreeSet<&str> {
    let rows = family.members.iter().flat_map(|device| &device.parameters).map(|row| row.id.as_str());
    let objects = family.members.iter().flat_map(|device| &device.objects);
    let on_object = objects.flat_map(|object| {
        let entries = object.entries.iter().filter_map(|entry| entry.parameter.as_deref());
        object.parameter.as_deref().into_iter().chain(entries)
    });
    rows.chain(on_object).collect()
}

/// Where a row of its own says what a parameter is.
fn row(name: &str) -> String {
    format!("<a id=\"parameter-{name}\"></a>`{name}`")
}

/// What is no link.
fn without_links(markdown: &str) -> String {
    let mut pieces = markdown.replace("\\[", "").replace("\\]", "");
    while let Some((before, after)) = pieces.split_once("](#") {
        let text = before.rsplit_once('[').map_or("", |(text, _)| text);
        pieces = format!("{text}{}", after.split_once(')').map_or("", |(_, rest)| rest));
    }
    pieces
}

#[test]
fn every_parameter_that_stands_as_code_is_a_link_but_in_its_own_row() {
    let mut linked = BTreeSet::new();
    for (family, text) in references() {
        for name in names(&family) {
            let span = format!("`{name}`");
            for (place, _) in text.match_indices(&span) {
                let (before, after) = text.split_at(place);
                let is_link = before.ends_with('[') && after[span.len()..].starts_with("](#");
                let is_own = text[..place + span.len()].ends_with(&row(name));
                let line = before.lines().next_back().unwrap_or_default();
                assert!(is_link || is_own, "{}: {name} behind {line}", family.id);
                linked.extend(is_link.then(|| (family.id.clone(), name.to_owned())));
            }
        }
    }
    let sc6 = |name: &str| ("pmc-sc6".to_owned(), name.to_owned());
    assert!(linked.contains(&sc6("A587[0]")) && linked.contains(&sc6("I102")), "{linked:?}");
}

#[test]
fn the_steps_of_homing_lead_to_each_parameter_that_they_name() {
    let references = references();
    let (family, text) =
        references.iter().find(|(family, _)| &*family.id == "pmc-sc6").expect("it is shipped");
    let chapter = text.split("<a id=\"homing\"></a>").nth(1).and_then(|rest| rest.split("\n## ").next());
    let steps: Vec<&str> = chapter
        .expect("a chapter on homing")
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()))
        .collect();
    assert!(steps.len() > 80, "{}", steps.len());
    for step in steps {
        let bare = without_links(step);
        let words = bare.split(|c: char| !c.is_ascii_alphanumeric());
        let named = words.filter(|word| names(family).contains(word)).count();
        assert_eq!(named, 0, "{step}");
    }
    assert!(
        chapter.unwrap_or_default().contains("With [I43](#parameter-I43) = 1, goes to [A569](#obj-607c).")
    );
}

#[test]
fn a_text_links_whole_names_and_leaves_units_and_words_alone() {
    let text = described(
        "[parameters]\nP1-01 = { name = \"Mode\" }\nV = { name = \"Voltage\" }\nstop = { name = \"Ramp\" }\n\
         \"0x19002010\" = { name = \"Cycle\" }\nDECSTOP = { name = \"Brake\" }\n\
         [[remarks]]\nat = \"device\"\ntext = \"Of 2.P1-01, P1-012, P1-01[3] and `P1-01` stop at 24 V by DECSTOP, 0x19002010.\"\nkind = \"doubt\"\n",
    );
    let line = between(&text, "| doubt | ", '|').next().unwrap_or_else(|| panic!("{text}"));
    let place = "](#parameter-P1-01)";
    let said = format!(
        "Of 2.[P1-01{place}, P1-012, [P1-01\\[3\\]{place} and [`P1-01`{place} stop at 24 V by \
         [DECSTOP](#parameter-DECSTOP), [`0x19002010`](#parameter-0x19002010)."
    );
    assert_eq!(line.trim(), said);
}
