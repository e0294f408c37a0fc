//! Two versions of a description are compared.

use bolero::TypeGenerator;
use devc::Compilation;
use devc::diff::{Class, Comparison, compare, findings, gate, json, markdown, text};
use devc::emit::{self, Emitter, Options};

use crate::edits::{Edit, edited, few};
use crate::run::holds;
use crate::subjects::{compile, small};

/// A description, and its edits in an old version and a new one.
#[derive(Debug, TypeGenerator)]
struct Input {
    subject: u16,
    #[generator(few())]
    old: Vec<Edit>,
    #[generator(few())]
    new: Vec<Edit>,
}

#[test]
fn versions() {
    holds("versions", 150, |input: &Input| {
        let files = edited(small(input.subject), &input.old);
        let old = compile(&files);
        let new = compile(&edited(&files, &input.new));
        let (Some(before), Some(after)) = (&old.family, &new.family) else { return };
        for (family, compilation) in [(before, &old), (after, &new)] {
            let same = compare(family, family);
            assert!(same.changes.is_empty(), "{}", said(&same, compilation, compilation));
        }
        let there = compare(before, after);
        let back = compare(after, before);
        assert_eq!(there.changes.is_empty(), back.changes.is_empty(), "{}", said(&there, &old, &new));
        are_told(&there, &old, &new);
        if there.changes.is_empty() {
            // what nobody is told of, no master, tool or program meets
            let made = |compilation: &Compilation| {
                let family = compilation.family.as_ref().expect("a family");
                let outputs: &[&dyn Emitter] =
                    &[&emit::esi::Esi, &emit::sii::Sii, &emit::c::C, &emit::eds::Eds];
                emit::emit(family, outputs, &Options::default())
            };
            assert!(made(&old) == made(&new), "outputs differ, and no change is told");
        }
    });
}

fn said(comparison: &Comparison, old: &Compilation, new: &Compilation) -> String {
    text(comparison, &old.sources, &new.sources, Class::Documentation)
}

/// Each change is in all forms of the comparison.
fn are_told(comparison: &Comparison, old: &Compilation, new: &Compilation) {
    let told = json(comparison, &old.sources, &new.sources);
    let told: serde_json::Value = serde_json::from_str(&told).unwrap_or_else(|why| panic!("{why}: {told}"));
    assert_eq!(told["changes"].as_array().map(Vec::len), Some(comparison.changes.len()));
    let found = findings(comparison, &old.sources, &new.sources, None);
    assert_eq!(found.iter().map(|it| it.count).sum::<usize>(), comparison.changes.len());
    let (lines, page) = (said(comparison, old, new), markdown(comparison));
    for change in &comparison.changes {
        let rule = &change.kind.rule;
        // a changelog says in words what breaks or is new, and counts what only people notice
        let is_on_page = change.kind.class == Class::Documentation || page.contains(rule.summary);
        assert!(lines.contains(rule.name) && is_on_page, "{} is not in\n{lines}\n{page}", rule.name);
        let places = [(change.old_at, old), (change.new_at, new)];
        for (at, of) in places.into_iter().filter_map(|(at, of)| Some((at?, of))) {
            assert!(of.sources.slice(at).is_some(), "{change:?}");
        }
    }
    let complaints = gate(comparison).iter().filter_map(devc::diff::Gate::complaint).count();
    assert!(complaints <= comparison.devices.len());
}
