//! Messages for programs. The format is frozen: what version 1 says, it says for ever.

use serde::Serialize;

use super::position::range;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::text::{Location, Position, Sources, characters as text};

#[derive(Serialize)]
struct Output {
    version: u32,
    diagnostics: Vec<Message>,
}

#[derive(Serialize)]
struct Message {
    rule: &'static str,
    group: &'static str,
    level: &'static str,
    message: String,
    labels: Vec<Label>,
    notes: Vec<String>,
    helps: Vec<Help>,
}

#[derive(Serialize)]
struct Label {
    #[serde(flatten)]
    place: Place,
    text: String,
}

#[derive(Serialize)]
struct Help {
    text: String,
    /// Whether a machine may make the edits without asking.
    sure: bool,
    edits: Vec<Edit>,
}

#[derive(Serialize)]
struct Edit {
    #[serde(flatten)]
    place: Place,
    replacement: String,
}

/// Lines and columns count from 1, columns in characters; offsets count bytes from 0.
#[derive(Serialize)]
struct Place {
    file: String,
    start: Point,
    end: Point,
}

#[derive(Serialize)]
struct Point {
    line: usize,
    column: usize,
    offset: u32,
}

/// The messages about several descriptions as one JSON document.
pub fn json(runs: &[(&Diagnostics, &Sources)]) -> String {
    let diagnostics = runs
        .iter()
        .flat_map(|(diagnostics, sources)| diagnostics.iter().map(|diagnostic| message(diagnostic, sources)));
    let output = Output { version: 1, diagnostics: diagnostics.collect() };
    text::json(&serde_json::to_string_pretty(&output).unwrap_or_default()).into_owned() + "\n"
}

fn message(diagnostic: &Diagnostic, sources: &Sources) -> Message {
    let Diagnostic { rule, level, message, labels, notes, helps, .. } = diagnostic;
    let place = |at: Location| place(at, sources);
    let edit =
        |edit: &crate::diagnostic::Edit| Edit { place: place(edit.at), replacement: edit.text.clone() };
    Message {
        rule: rule.name,
        group: rule.group.name(),
        level: level.word(),
        message: message.clone(),
        labels: labels.iter().map(|l| Label { place: place(l.at), text: l.text.clone() }).collect(),
        notes: notes.clone(),
        helps: helps
            .iter()
            .map(|help| Help {
                text: help.text.clone(),
                sure: help.sure,
                edits: help.edits.iter().map(edit).collect(),
            })
            .collect(),
    }
}

fn place(at: Location, sources: &Sources) -> Place {
    let (start, end) = range(at, sources);
    let point = |position: Position, offset| Point { line: position.line, column: position.column, offset };
    Place {
        file: sources.get(at.file).map(|file| file.path.clone()).unwrap_or_default(),
        start: point(start, at.start),
        end: point(end, at.end),
    }
}
