//! Messages in the manner of rustc: the text around each place, with what there is to say about it.

use std::borrow::Cow;
use std::ops::Range;

use annotate_snippets::{
    Annotation, AnnotationKind, Element, Group, Level as Severity, Origin, Patch, Renderer, Snippet,
};

use super::window::{Shown, Window, line_length, windows};
use crate::diagnostic::{Diagnostic, Edit, Help, Label, Level};
use crate::text::Sources;
use crate::text::characters::{harmless, line};

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
///
/// Nothing in it moves a terminal but the colours: what the message says and what stands in a file is shown, not obeyed.
pub fn text(diagnostic: &Diagnostic, sources: &Sources, style: Style) -> String {
    let renderer = match style {
        Style::Plain => Renderer::plain(),
        Style::Colour => Renderer::styled(),
    };
    let text = renderer.term_width(WIDTH).render(&groups(diagnostic, sources));
    match style {
        Style::Plain => harmless(&text).into_owned(),
        // Behind each escape is what the renderer wrote: those of a message are gone, those of a file are signs.
        Style::Colour => text.split('\u{1B}').map(harmless).collect::<Vec<Cow<'_, str>>>().join("\u{1B}"),
    }
}

/// What is wrong first, then each help with an edit; helps without one stand with the notes.
fn groups<'a>(diagnostic: &'a Diagnostic, sources: &'a Sources) -> Vec<Group<'a>> {
    let severity = match diagnostic.level {
        Level::Error => Severity::ERROR,
        Level::Warning => Severity::WARNING,
        Level::Allow => Severity::INFO,
    };
    let title = severity.primary_title(line(&diagnostic.message)).id(diagnostic.rule.name);
    let (edits, advice): (Vec<&Help>, Vec<&Help>) =
        diagnostic.helps.iter().partition(|help| has_edits(help, sources));
    let main = Group::with_title(title)
        .elements(snippets(&diagnostic.labels, sources))
        .elements(diagnostic.notes.iter().map(|note| Severity::NOTE.message(line(note))))
        .elements(advice.into_iter().map(|help| Severity::HELP.message(line(&help.text))));
    let edits = edits.into_iter().map(|help| {
        let title = Severity::HELP.secondary_title(line(&help.text));
        Group::with_title(title).elements(patches(&help.edits, sources))
    });
    std::iter::once(main).chain(edits).collect()
}

/// Whether there are edits that can be shown as a diff: in files that the reader can edit, and in lines that
/// fit, since a diff shows them whole.
fn has_edits(help: &Help, sources: &Sources) -> bool {
    let can_be_shown = |edit: &Edit| {
        let file = sources.lines(edit.at.file).filter(|(file, _)| !file.embedded);
        file.is_some_and(|(file, lines)| line_length(edit.at, file, lines) <= WIDTH)
    };
    !help.edits.is_empty() && help.edits.iter().all(can_be_shown)
}

/// What is shown of the files, that of the first label first.
fn snippets<'a>(labels: &'a [Label], sources: &'a Sources) -> Vec<Element<'a>> {
    let mut elements = Vec::new();
    for shown in windows(labels.iter().map(|label| label.at), sources) {
        match shown {
            Shown::Window(window) => {
                let marks = window.places.iter().filter_map(|(number, range)| {
                    Some(annotation(*number == 0, labels.get(*number)?, range.clone()))
                });
                elements.push(snippet(&window).annotations(marks).into());
            }
            Shown::Place { number, path, position } => {
                let origin = Origin::path(line(path)).line(position.line).char_column(position.column);
                elements.push(origin.into());
                let text = labels.get(number).map_or("", |label| label.text.as_str());
                let text = Some(line(text)).filter(|text| !text.is_empty());
                elements.extend(text.map(|text| Severity::NOTE.message(text).into()));
            }
        }
    }
    elements
}

fn snippet<'a, T: Clone>(window: &Window<'a>) -> Snippet<'a, T> {
    Snippet::source(window.text).line_start(window.line).path(line(window.path))
}

fn annotation(primary: bool, label: &Label, range: Range<usize>) -> Annotation<'_> {
    let kind = if primary { AnnotationKind::Primary } else { AnnotationKind::Context };
    let text = Some(line(&label.text)).filter(|text| !text.is_empty());
    kind.span(range).label(text)
}

fn patches<'a>(edits: &'a [Edit], sources: &'a Sources) -> Vec<Element<'a>> {
    let windows = windows(edits.iter().map(|edit| edit.at), sources).into_iter();
    let windows = windows.filter_map(|shown| match shown {
        Shown::Window(window) => Some(window),
        Shown::Place { .. } => None,
    });
    let element = |window: Window<'a>| {
        let patches = window
            .places
            .iter()
            .filter_map(|(number, range)| Some(Patch::new(range.clone(), edits.get(*number)?.text.as_str())));
        snippet(&window).patches(patches).into()
    };
    windows.map(element).collect()
}
