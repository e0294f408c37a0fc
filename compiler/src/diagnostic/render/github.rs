//! Messages as GitHub shows them beside the lines of a pull request.

use super::position::Positions;
use crate::diagnostic::{Diagnostic, Diagnostics, Level};
use crate::text::Sources;

/// A workflow command for each message.
pub fn github(diagnostics: &Diagnostics, sources: &Sources) -> String {
    let positions = Positions::new(sources);
    diagnostics.iter().map(|diagnostic| command(diagnostic, sources, &positions)).collect()
}

fn command(diagnostic: &Diagnostic, sources: &Sources, positions: &Positions<'_>) -> String {
    let name = match diagnostic.level {
        Level::Error => "error",
        Level::Warning => "warning",
        Level::Allow => "notice",
    };
    let rule = diagnostic.rule.name;
    let place = diagnostic.at().and_then(|at| {
        let file = sources.get(at.file).filter(|file| !file.embedded)?;
        let (start, end) = positions.range(at);
        let lines = format!("line={},endLine={}", start.line, end.line);
        // Columns mean nothing to GitHub when the range spans lines.
        let columns = if start.line == end.line {
            format!(",col={},endColumn={}", start.column, end.column)
        } else {
            String::new()
        };
        Some(format!("file={},{lines}{columns},", property(&file.path)))
    });
    let place = place.unwrap_or_default();
    format!("::{name} {place}title={}::{}\n", property(rule), data(&whole(diagnostic)))
}

/// All there is to say, since GitHub shows one text only.
fn whole(diagnostic: &Diagnostic) -> String {
    let helps = diagnostic.helps.iter().map(|help| format!("help: {}", help.text));
    let notes = diagnostic.notes.iter().map(|note| format!("note: {note}"));
    let lines: Vec<String> = std::iter::once(diagnostic.message.clone()).chain(notes).chain(helps).collect();
    lines.join("\n")
}

fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
