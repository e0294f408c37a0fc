//! What is wrong with a description, for the editor to mark.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use devc::Compilation;
use devc::diagnostic::{Diagnostic, Level};
use devc::source::{FileId, Location, Sources};
use serde_json::{Value, json};

use super::state::State;
use super::text::Text;

/// The texts of a compilation as editors count in them, each made when it is first needed.
struct Texts<'c> {
    sources: &'c Sources,
    made: BTreeMap<FileId, Text>,
}

impl Texts<'_> {
    fn range(&mut self, at: Location) -> Value {
        let text = self
            .made
            .entry(at.file)
            .or_insert_with(|| Text::new(self.sources.get(at.file).map_or("", |file| file.text.as_str())));
        json!(text.range(&bytes(at)))
    }
}

/// A place in bytes.
pub(super) fn bytes(at: Location) -> std::ops::Range<usize> {
    let place = |place| usize::try_from(place).unwrap_or(usize::MAX);
    place(at.start)..place(at.end)
}

/// Sends the messages about each file, and for those that had messages before and have none now that there are none.
pub(super) fn publish(
    state: &mut State,
    main: &Path,
    compilation: &Compilation,
    versions: &BTreeMap<PathBuf, i32>,
    marked: &mut BTreeSet<PathBuf>,
) {
    let mut texts = Texts { sources: &compilation.sources, made: BTreeMap::new() };
    let mut files: BTreeMap<PathBuf, Vec<Value>> = BTreeMap::new();
    for diagnostic in compilation.diagnostics.iter().filter(|it| it.level != Level::Allow) {
        let at = diagnostic
            .labels
            .iter()
            .map(|label| label.at)
            .find(|at| compilation.sources.name(at.file).is_some());
        let file = at.and_then(|at| compilation.sources.name(at.file)).unwrap_or(main);
        let said = message(state, diagnostic, at, &mut texts);
        files.entry(file.to_owned()).or_default().push(said);
    }
    let gone: Vec<PathBuf> = marked.iter().filter(|file| !files.contains_key(*file)).cloned().collect();
    *marked = files.keys().cloned().collect();
    for (file, messages) in files.into_iter().chain(gone.into_iter().map(|file| (file, Vec::new()))) {
        let version = versions.get(&file);
        let uri = state.uri(&file);
        let about = json!({ "uri": uri, "version": version, "diagnostics": messages });
        state.notify("textDocument/publishDiagnostics", about);
    }
}

/// Takes all messages back.
pub(super) fn clear(state: &State, marked: &BTreeSet<PathBuf>) {
    for file in marked {
        let about = json!({ "uri": state.uri(file), "diagnostics": [] });
        state.notify("textDocument/publishDiagnostics", about);
    }
}

/// A message at a place; what it says of other places is related to it.
fn message(state: &mut State, diagnostic: &Diagnostic, at: Option<Location>, texts: &mut Texts<'_>) -> Value {
    let start = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } });
    let mut related = Vec::new();
    let mut said = diagnostic.message.clone();
    for label in &diagnostic.labels {
        if Some(label.at) == at {
            let text = Some(&label.text).filter(|text| !text.is_empty());
            said.extend(text.map(|text| format!(": {text}")));
        } else if let Some(uri) = place(state, texts.sources, label.at) {
            let location = json!({ "uri": uri, "range": texts.range(label.at) });
            related.push(json!({ "location": location, "message": label.text }));
        }
    }
    said.extend(diagnostic.notes.iter().map(|note| format!("\nnote: {note}")));
    said.extend(diagnostic.helps.iter().map(|help| format!("\nhelp: {}", help.text)));
    json!({
        "range": at.map_or(start, |at| texts.range(at)),
        "severity": if diagnostic.level == Level::Error { 1 } else { 2 },
        "code": diagnostic.rule.name,
        "source": "devc",
        "message": said,
        "relatedInformation": related,
    })
}

/// The address of the text that a place is in; a profile is written to a file for that.
pub(super) fn place(state: &mut State, sources: &Sources, at: Location) -> Option<String> {
    if let Some(name) = sources.name(at.file) {
        return Some(state.uri(name));
    }
    let file = sources.get(at.file).filter(|file| file.embedded)?;
    let name = file.path.strip_prefix("<profile ")?.strip_suffix('>')?;
    state.profiles.file(name, &file.text).map(|path| super::uri::uri(&path))
}
