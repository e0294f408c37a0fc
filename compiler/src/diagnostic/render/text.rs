//! Messages in the manner of rustc: the text around each place, with what there is to say about it.

use std::ops::Range;

use annotate_snippets::{
    Annotation, AnnotationKind, Element, Group, Level as Severity, Patch, Renderer, Snippet,
};

use crate::diagnostic::{Diagnostic, Edit, Help, Label, Level};
use crate::text::{FileId, Location, SourceFile, Sources};

/// Columns of the output: longer lines are cut around what is marked.
const WIDTH: usize = 140;

/// How the text looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// ASCII, the same everywhere.
    Plain,
    /// With colours for a terminal.
    Colour,
}

/// The message as a paragraph of text, without a newline at its end.
pub fn text(diagnostic: &Diagnostic, sources: &Sources, style: Style) -> String {
    let renderer = match style {
        Style::Plain => Renderer::plain(),
        Style::Colour => Renderer::styled(),
    };
    renderer.term_width(WIDTH).render(&groups(diagnostic, sources))
}

/// What is wrong first, then each help with an edit; helps without one stand with the notes.
fn groups<'a>(diagnostic: &'a Diagnostic, sources: &'a Sources) -> Vec<Group<'a>> {
    let severity = match diagnostic.level {
        Level::Error => Severity::ERROR,
        Level::Warning => Severity::WARNING,
        Level::Allow => Severity::INFO,
    };
    let title = severity.primary_title(diagnostic.message.as_str()).id(diagnostic.rule.name);
    let (edits, advice): (Vec<&Help>, Vec<&Help>) =
        diagnostic.helps.iter().partition(|help| has_edits(help, sources));
    let main = Group::with_title(title)
        .elements(snippets(&diagnostic.labels, sources))
        .elements(diagnostic.notes.iter().map(|note| Severity::NOTE.message(note.as_str())))
        .elements(advice.into_iter().map(|help| Severity::HELP.message(help.text.as_str())));
    let edits = edits.into_iter().map(|help| {
        let title = Severity::HELP.secondary_title(help.text.as_str());
        Group::with_title(title).elements(patches(&help.edits, sources))
    });
    std::iter::once(main).chain(edits).collect()
}

/// Whether there are edits that can be shown as a diff: in files that the reader can edit, and in lines that
/// fit, since a diff shows them whole.
fn has_edits(help: &Help, sources: &Sources) -> bool {
    let can_be_shown = |edit: &Edit| {
        sources
            .get(edit.at.file)
            .is_some_and(|file| !file.embedded && line_length(edit.at, &file.text) <= WIDTH)
    };
    !help.edits.is_empty() && help.edits.iter().all(can_be_shown)
}

/// The length of the lines that a place covers, in bytes.
fn line_length(at: Location, text: &str) -> usize {
    let Range { start, end } = range(at, text);
    let before = text.get(..start).unwrap_or_default().rfind('\n').map_or(0, |newline| newline + 1);
    let after = text.get(end..).unwrap_or_default().find('\n').map_or(text.len(), |newline| end + newline);
    after - before
}

/// One snippet a file, the file of the first label first.
fn snippets<'a>(labels: &'a [Label], sources: &'a Sources) -> Vec<Element<'a>> {
    let snippet = |id| {
        let file = sources.get(id)?;
        let marks = labels.iter().enumerate().filter(|(_, label)| label.at.file == id);
        let marks = marks.map(|(place, label)| annotation(place == 0, label, file));
        Some(Snippet::source(file.text.as_str()).path(file.path.as_str()).annotations(marks).into())
    };
    files(labels.iter().map(|label| label.at)).into_iter().filter_map(snippet).collect()
}

fn annotation<'a>(primary: bool, label: &'a Label, file: &SourceFile) -> Annotation<'a> {
    let kind = if primary { AnnotationKind::Primary } else { AnnotationKind::Context };
    let text = Some(label.text.as_str()).filter(|text| !text.is_empty());
    kind.span(range(label.at, &file.text)).label(text)
}

fn patches<'a>(edits: &'a [Edit], sources: &'a Sources) -> Vec<Element<'a>> {
    let snippet = |id| {
        let file = sources.get(id)?;
        let edits = edits.iter().filter(|edit| edit.at.file == id);
        let patches = edits.map(|edit| Patch::new(range(edit.at, &file.text), edit.text.as_str()));
        Some(Snippet::source(file.text.as_str()).path(file.path.as_str()).patches(patches).into())
    };
    files(edits.iter().map(|edit| edit.at)).into_iter().filter_map(snippet).collect()
}

/// The files of some places, each once.
fn files(places: impl Iterator<Item = Location>) -> Vec<FileId> {
    let mut files = Vec::new();
    for place in places {
        if !files.contains(&place.file) {
            files.push(place.file);
        }
    }
    files
}

/// The bytes of a place, moved to where characters begin so that no text can be cut in one.
fn range(at: Location, text: &str) -> Range<usize> {
    let floor = |offset: u32| {
        let offset = usize::try_from(offset).unwrap_or(usize::MAX).min(text.len());
        (0..=offset).rev().find(|offset| text.is_char_boundary(*offset)).unwrap_or(0)
    };
    let start = floor(at.start);
    start..floor(at.end).max(start)
}
