//! What devc can do about what is wrong.

use std::ops::Range;
use std::path::Path;

use devc::Compilation;
use devc::diagnostic::{Diagnostic, Help};
use serde_json::{Map, Value, json};

use super::publish::bytes;
use super::state::State;
use super::text::Text;

/// The edits that messages about a part of a file suggest, as long as the file is as they saw it.
pub(super) fn actions(
    state: &State,
    file: &Path,
    part: &Range<usize>,
    compilation: &Compilation,
) -> Vec<Value> {
    let sources = &compilation.sources;
    let is_here = |diagnostic: &&Diagnostic| {
        diagnostic.labels.iter().any(|label| {
            let at = bytes(label.at);
            sources.name(label.at.file) == Some(file) && at.start <= part.end && part.start <= at.end
        })
    };
    let here = compilation.diagnostics.iter().filter(is_here);
    let helps = here.flat_map(|diagnostic| diagnostic.helps.iter().map(move |help| (diagnostic, help)));
    let actions = helps.filter(|(_, help)| !help.edits.is_empty()).filter_map(|(diagnostic, help)| {
        let edit = edit(state, help, compilation)?;
        Some(json!({
            "title": title(diagnostic, help),
            "kind": "quickfix",
            "isPreferred": help.sure,
            "edit": edit,
        }))
    });
    actions.collect()
}

fn title(diagnostic: &Diagnostic, help: &Help) -> String {
    let text = help.text.trim_end_matches('?').replace("did you mean", "write");
    format!("{text} ({})", diagnostic.rule.name)
}

fn edit(state: &State, help: &Help, compilation: &Compilation) -> Option<Value> {
    let mut changes: Map<String, Value> = Map::new();
    for edit in &help.edits {
        let name = compilation.sources.name(edit.at.file)?;
        let text = &compilation.sources.get(edit.at.file)?.text;
        if state.open.get(name).is_some_and(|open| *open.text.text != **text) {
            return None;
        }
        let range = Text::new(text.as_str()).range(&bytes(edit.at));
        let edits = changes.entry(state.uri(name)).or_insert_with(|| json!([]));
        edits.as_array_mut()?.push(json!({ "range": range, "newText": edit.text }));
    }
    Some(json!({ "changes": changes }))
}
