use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;
use crate::source::{Layer, Location, Member, Table, Value};
use crate::text::near::{near, nearly};

rule! {
    /// A source is a place in the first of `[documents]`, or in another one whose word stands before a colon. One whose word
    /// is not listed, or that has no colon and a space behind it, counts as a place in the first document, where the fact
    /// is not found.
    ///
    /// What has a number in it, as the name of a standard, is a place like any other unless it is like the word of a document.
    ///
    /// ## Fires
    /// ```toml
    /// [documents]
    /// manual = { title = "Manual" }
    /// guide = { title = "Installation Guide" }
    ///
    /// [leds.run]
    /// name = "RUN"
    /// source = "giude: 3.2"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [documents]
    /// manual = { title = "Manual" }
    /// guide = { title = "Installation Guide" }
    ///
    /// [leds.run]
    /// name = "RUN"
    /// source = "guide: 3.2"
    /// ```
    pub(super) static RULE = "unlisted-document", Facts, Warning, "a source names a document that is not listed";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let documents: Vec<&str> = device.documents.iter().map(|document| &*document.id).collect();
    if documents.is_empty() {
        return;
    }
    let mut seen = BTreeSet::new();
    for written in &device.written.0 {
        sources(written.origin.table(), &mut |text, at| {
            if seen.insert(at) {
                let found = parts(text).find_map(|part| fault(part, &documents, at));
                found.into_iter().for_each(|diagnostic| report.push(written.place.clone(), diagnostic));
            }
        });
    }
}

/// The sources that a table of the description and the tables in it give.
fn sources(table: &Table, found: &mut impl FnMut(&str, Location)) {
    for Member { key, node, layer, .. } in &table.members {
        match &node.value {
            Value::String(text) if &*key.name == "source" && *layer != Layer::Profile => found(text, node.at),
            Value::Table(inner) if &*key.name != "assumed" => sources(inner, found),
            _ => {}
        }
    }
}

/// The places that a source names.
fn parts(text: &str) -> impl Iterator<Item = &str> {
    text.split(';').map(str::trim)
}

/// What is wrong with a place that begins like one in a document.
fn fault(place: &str, documents: &[&str], at: Location) -> Option<Diagnostic> {
    let (word, rest) = place.split_once(|c: char| c == ':' || c.is_whitespace())?;
    let is_named = place.starts_with(&format!("{word}:"));
    let rest = rest.trim_start();
    match documents.iter().find(|document| document.eq_ignore_ascii_case(word)) {
        Some(document) if place.starts_with(&format!("{document}: ")) => None,
        Some(document) => {
            let message = format!("the source `{place}` does not name `{document}` as sources do");
            let diagnostic = Diagnostic::new(&RULE, message, at, "counts as a place in the first document");
            Some(diagnostic.help(format!("write `{document}: {rest}`")))
        }
        None => {
            let known = || documents.iter().copied();
            let is_word = word.chars().all(|c| c.is_alphabetic() || matches!(c, '-' | '_'));
            // `p.` and `3.5,` begin places of all kinds
            let is_telling = word.chars().filter(|c| c.is_alphabetic()).nth(2).is_some();
            let meant = match is_named {
                true => near(word, known()),
                false => nearly(word, known().filter(|_| is_telling)),
            };
            if meant.is_none() && !(is_named && is_word) {
                return None;
            }
            let message = format!("the source `{place}` names a document `{word}`, which is not listed");
            let diagnostic = Diagnostic::new(&RULE, message, at, "not one of `[documents]`");
            Some(match meant {
                Some(meant) => diagnostic.help(format!("did you mean `{meant}: {rest}`?")),
                None => diagnostic.help("list it, or say the place without a colon"),
            })
        }
    }
}
