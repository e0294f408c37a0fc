//! Messages as GitHub shows them beside the lines of a pull request.

use super::position::range;
use crate::diagnostic::{Diagnostic, Diagnostics, Level};
use crate::text::Sources;
use crate::text::characters::line;

/// A workflow command for each message.
pub fn github(diagnostics: &Diagnostics, sources: &Sources) -> String {
    diagnostics.iter().map(|diagnostic| command(diagnostic, sources)).collect()
}

fn command(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let name = match diagnostic.level {
        Level::Error => "error",
        Level::Warning => "warning",
        Level::Allow => "notice",
    };
    let rule = diagnostic.rule.name;
    let place = diagnostic.at().and_then(|at| {
        let file = sources.get(at.file).filter(|file| !file.embedded)?;
        let (start, end) = range(at, sources);
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
    let helps = diagnostic.helps.iter().map(|help| format!("help: {}", line(&help.text)));
    let notes = diagnostic.notes.iter().map(|note| format!("note: {}", line(note)));
    let message = line(&diagnostic.message).into_owned();
    std::iter::once(message).chain(notes).chain(helps).collect::<Vec<_>>().join("\n")
}

/// Lines as the text of a command: a runner reads commands line by line, and knows `%` for what it would take for
/// something else.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(&line(text)).replace(':', "%3A").replace(',', "%2C")
}
