//! Texts become messages and outputs.

use bolero::TypeGenerator;
use devc::Compilation;
use devc::diagnostic::render::{Style, github, json, sarif, text};
use devc::diagnostic::{Diagnostic, KEPT, Level};
use devc::emit::{self, Files, Options};
use devc::text::characters::hazard;

use crate::edits::{Edit, edited, few};
use crate::run::holds;
use crate::subjects::{compile, subject};

/// A description that somebody edited.
#[derive(Debug, TypeGenerator)]
struct Input {
    subject: u16,
    #[generator(few())]
    edits: Vec<Edit>,
}

#[test]
fn descriptions() {
    holds("descriptions", 150, |input: &Input| {
        let files = edited(subject(input.subject), &input.edits);
        let compilation = compile(&files);
        let diagnostics = &compilation.diagnostics;
        assert_eq!(compilation.family.is_none(), diagnostics.has_errors(), "either devices or errors");
        assert!(diagnostics.iter().count() <= (KEPT + 1) * 200, "{} messages", diagnostics.iter().count());
        for diagnostic in diagnostics.iter() {
            is_sound(diagnostic, &compilation);
        }
        are_rendered(&compilation);
        if let Some(family) = &compilation.family {
            are_whole(&emit::emit(family, emit::ALL, &Options::default()));
        }
    });
}

/// A message points into the texts, says something, and nothing that a terminal would obey.
fn is_sound(diagnostic: &Diagnostic, compilation: &Compilation) {
    let sources = &compilation.sources;
    let labels = diagnostic.labels.iter().map(|label| label.at);
    let edits = diagnostic.helps.iter().flat_map(|help| &help.edits).map(|edit| edit.at);
    for at in labels.chain(edits) {
        assert!(sources.slice(at).is_some(), "{at:?} of {diagnostic:?}");
    }
    assert!(!diagnostic.message.is_empty() && diagnostic.count > 0, "{diagnostic:?}");
    let text = text(diagnostic, sources, Style::Plain);
    assert!(text.contains(diagnostic.rule.name) && is_harmless(&text), "{text:?}");
    assert!(text.len() < 200_000, "{} bytes of {}", text.len(), diagnostic.rule.name);
}

fn is_harmless(text: &str) -> bool {
    text.chars().all(|c| hazard(c).is_none())
}

/// The formats for programs are what they are called.
fn are_rendered(compilation: &Compilation) {
    let Compilation { diagnostics, sources, .. } = compilation;
    let told = github(diagnostics, sources);
    assert!(told.lines().all(|line| line.starts_with("::")) && is_harmless(&told), "{told}");
    let runs = [(diagnostics, sources)];
    for text in [json(&runs), sarif(&runs, &[])] {
        assert!(is_harmless(&text), "{text:?}");
        is_json("messages", &text);
    }
    assert_eq!(diagnostics.count(Level::Error) > 0, diagnostics.has_errors());
}

/// Each output is what its readers take it for.
fn are_whole(files: &Files) {
    for (name, content) in &files.0 {
        let Ok(text) = std::str::from_utf8(content) else {
            assert!(name.ends_with(".bin"), "{name} is no text");
            continue;
        };
        assert!(!text.is_empty() && (name.ends_with(".bin") || is_harmless(text)), "{name}: {text:?}");
        match name.rsplit('.').next() {
            Some("json") => is_json(name, text),
            Some("xml") => {
                roxmltree::Document::parse(text).unwrap_or_else(|why| panic!("{name}: {why}"));
            }
            Some("rs") => {
                syn::parse_file(text).unwrap_or_else(|why| panic!("{name}: {why}"));
            }
            _ => {}
        }
    }
}

fn is_json(name: &str, text: &str) {
    let _: serde_json::Value = serde_json::from_str(text).unwrap_or_else(|why| panic!("{name}: {why}"));
}
