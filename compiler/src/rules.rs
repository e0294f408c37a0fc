//! All rules as a book: by name, as text for a terminal, as the reference `compiler/docs/rules.md`.

use std::fmt::Write as _;

use crate::diagnostic::{Group, Level, Rule, faults};
use crate::lint;
use crate::text::near::near;

/// Every rule that a message can be about, by name.
pub fn all() -> Vec<&'static Rule> {
    let lints = lint::ALL.iter().map(|lint| lint.rule);
    let mut rules: Vec<_> = faults::ALL.iter().copied().chain(lints).collect();
    rules.sort_unstable_by_key(|rule| rule.name);
    rules
}

/// The rule of this name.
///
/// # Errors
/// If there is none: the name that looks most like it, if one does.
pub fn find(name: &str) -> Result<&'static Rule, Option<&'static str>> {
    let rules = all();
    let found = rules.iter().find(|rule| rule.name == name);
    found.copied().ok_or_else(|| near(name, rules.iter().map(|rule| rule.name)))
}

/// What a rule does if nobody says otherwise, in a few words.
pub fn default_level(rule: &Rule) -> &'static str {
    match (rule.fixed, rule.level) {
        (true, _) => "always an error",
        (false, Level::Error) => "error by default",
        (false, Level::Warning) => "warning by default",
        (false, Level::Allow) => "silent by default",
    }
}

/// The documentation of a rule as Markdown, without the space that a doc comment puts before each line.
pub fn docs(rule: &Rule) -> String {
    let lines: Vec<&str> =
        rule.docs.lines().map(|line| line.strip_prefix(' ').unwrap_or(line).trim_end()).collect();
    lines.join("\n").trim().to_owned()
}

/// The reference of all rules as Markdown: for each group a table of its rules, then each of them by name.
pub fn reference() -> String {
    let rules = all();
    let mut out = String::from(PREFACE);
    for group in Group::ALL {
        let members: Vec<_> = rules.iter().copied().filter(|rule| rule.group == group).collect();
        if members.is_empty() {
            continue;
        }
        let _ = write!(out, "\n## {}\n\n| rule | level | fault |\n|---|---|---|\n", title(group));
        for rule in &members {
            let _ =
                writeln!(out, "| [`{0}`](#{0}) | {1} | {2} |", rule.name, default_level(rule), rule.summary);
        }
        out.extend(members.into_iter().map(section));
    }
    out
}

fn section(rule: &Rule) -> String {
    let docs = docs(rule).replace("\n## ", "\n#### ");
    format!("\n### {}\n\n*{}; {}*\n\n{docs}\n", rule.name, rule.summary, default_level(rule))
}

const PREFACE: &str = "\
<!-- Generated from the doc comments of the rules; `cargo accept` brings it up to date. -->

# Rules

Every message of devc is about one rule, whose name it prints: `error[unknown-key]: ...`. The same text comes
from `devc explain unknown-key`. Each rule has an example that breaks it and one that keeps it; the tests
compile both. A line `# file: name` in an example begins another file, and what all descriptions have in common
(`[device]`, `[identity]`) is left out.
";

/// What the rules of a group are about.
fn title(group: Group) -> &'static str {
    match group {
        Group::Format => "Format",
        Group::Dictionary => "Object dictionary",
        Group::ProcessData => "Process data",
        Group::StateMachine => "State machine",
        Group::Values => "Values",
        Group::Output => "Outputs",
        Group::Facts => "Facts and their sources",
        Group::Changes => "Changes",
    }
}
