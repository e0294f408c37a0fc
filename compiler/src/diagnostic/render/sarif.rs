//! Messages in SARIF 2.1.0, the format of code scanning.

use serde_json::{Value, json};

use super::position::range;
use crate::diagnostic::{Diagnostic, Diagnostics, Level, Rule};
use crate::text::{Location, Sources, characters as text};

/// The messages about several descriptions as one SARIF log, with the table of all rules.
pub fn sarif(runs: &[(&Diagnostics, &Sources)], rules: &[&Rule]) -> String {
    let results: Vec<Value> = runs
        .iter()
        .flat_map(|(diagnostics, sources)| {
            let places = Places { sources };
            diagnostics.iter().map(move |diagnostic| result(diagnostic, &places, rules))
        })
        .collect();
    let failed = runs.iter().any(|(diagnostics, _)| diagnostics.has_errors());
    let log = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "devc",
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": rules.iter().map(|rule| descriptor(rule)).collect::<Vec<_>>(),
            }},
            "columnKind": "utf16CodeUnits",
            "originalUriBaseIds": { "SRCROOT": { "description": { "text": "the folder devc was run in" } } },
            "invocations": [{ "executionSuccessful": true, "exitCode": i32::from(failed) }],
            "results": results,
        }],
    });
    text::json(&serde_json::to_string_pretty(&log).unwrap_or_default()).into_owned() + "\n"
}

fn descriptor(rule: &Rule) -> Value {
    json!({
        "id": rule.name,
        "name": pascal(rule.name),
        "shortDescription": { "text": rule.summary },
        "fullDescription": { "text": why(rule) },
        "help": { "text": why(rule), "markdown": rule.docs },
        "defaultConfiguration": { "level": level(rule.level) },
        "properties": { "tags": [rule.group.name()] },
    })
}

/// The documentation up to its examples.
fn why(rule: &Rule) -> String {
    let text = rule.docs.split("## Fires").next().unwrap_or_default();
    text.lines().map(str::trim).collect::<Vec<_>>().join(" ").trim().to_owned()
}

fn pascal(name: &str) -> String {
    name.split('-')
        .map(|part| {
            let mut chars = part.chars();
            chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
        })
        .collect()
}

fn level(level: Level) -> &'static str {
    match level {
        Level::Error => "error",
        Level::Warning => "warning",
        Level::Allow => "none",
    }
}

struct Places<'s> {
    sources: &'s Sources,
}

impl Places<'_> {
    fn artifact(&self, at: Location) -> Value {
        match self.sources.get(at.file) {
            Some(file) if file.embedded => json!({ "uri": format!("devc:{}", encoded(&file.path)) }),
            Some(file) => json!({ "uri": encoded(&file.path), "uriBaseId": "SRCROOT" }),
            None => json!({}),
        }
    }

    fn region(&self, at: Location) -> Value {
        let (start, end) = range(at, self.sources);
        json!({
            "startLine": start.line,
            "startColumn": start.column_utf16,
            "endLine": end.line,
            "endColumn": end.column_utf16,
        })
    }

    fn location(&self, at: Location, text: &str) -> Value {
        let mut location = json!({
            "physicalLocation": { "artifactLocation": self.artifact(at), "region": self.region(at) },
        });
        if let (false, Some(object)) = (text.is_empty(), location.as_object_mut()) {
            object.insert("message".to_owned(), json!({ "text": text }));
        }
        location
    }
}

/// A path as a URI may hold it.
fn encoded(path: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/-._~".contains(&byte);
    let encode = |byte| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    path.bytes().map(encode).collect()
}

fn result(diagnostic: &Diagnostic, places: &Places<'_>, rules: &[&Rule]) -> Value {
    let rule = diagnostic.rule;
    let (primary, related) = match diagnostic.labels.split_first() {
        Some((primary, related)) => (Some(primary), related),
        None => (None, &[][..]),
    };
    let location = |label: &crate::diagnostic::Label| places.location(label.at, &label.text);
    json!({
        "ruleId": rule.name,
        "ruleIndex": rules.iter().position(|other| other.name == rule.name),
        "level": if diagnostic.level == Level::Allow { "note" } else { level(diagnostic.level) },
        "message": { "text": said(diagnostic) },
        "locations": primary.map(location).into_iter().collect::<Vec<_>>(),
        "relatedLocations": related.iter().map(location).collect::<Vec<_>>(),
        "fixes": fixes(diagnostic, places),
    })
}

/// The message with its notes and helps, since SARIF has no other place for them.
fn said(diagnostic: &Diagnostic) -> String {
    let notes = diagnostic.notes.iter().map(|note| format!("\nnote: {note}"));
    let helps = diagnostic.helps.iter().map(|help| format!("\nhelp: {}", help.text));
    diagnostic.message.clone() + &notes.chain(helps).collect::<String>()
}

fn fixes(diagnostic: &Diagnostic, places: &Places<'_>) -> Vec<Value> {
    let mechanical = diagnostic.helps.iter().filter(|help| !help.edits.is_empty());
    mechanical
        .map(|help| {
            let changes: Vec<Value> = help
                .edits
                .iter()
                .map(|edit| {
                    json!({
                        "artifactLocation": places.artifact(edit.at),
                        "replacements": [{
                            "deletedRegion": places.region(edit.at),
                            "insertedContent": { "text": edit.text },
                        }],
                    })
                })
                .collect();
            json!({ "description": { "text": help.text }, "artifactChanges": changes })
        })
        .collect()
}
