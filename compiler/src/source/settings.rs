//! The keys at the top of a file that say how to read it, not what the drive is.

use std::sync::Arc;

use super::{Location, Member, Node, Table, Value};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};

/// What a file says about itself: its includes, its profiles, the source of what is in it.
pub(super) struct Settings {
    pub(super) include: Vec<(Arc<str>, Location)>,
    pub(super) profiles: Vec<(Arc<str>, Location)>,
    pub(super) source: Option<Member>,
}

impl Settings {
    /// Takes the settings out of a file's table.
    pub(super) fn take(table: &mut Table, diagnostics: &mut Diagnostics) -> Self {
        let include = strings(table, "include", diagnostics);
        let profiles = strings(table, "profiles", diagnostics);
        Self { include, profiles, source: take(table, "source") }
    }
}

fn take(table: &mut Table, name: &str) -> Option<Member> {
    let place = table.members.place(name)?;
    table.members.remove(place)
}

/// The strings of a list at the top of a file.
fn strings(table: &mut Table, name: &str, diagnostics: &mut Diagnostics) -> Vec<(Arc<str>, Location)> {
    let Some(member) = take(table, name) else { return Vec::new() };
    let mut wrong = |at, expected: &str, value: &Value| {
        let message = format!("`{name}` has to be a list of strings");
        let label = format!("expected {expected}, found {}", value.kind());
        diagnostics.push(Diagnostic::new(&faults::WRONG_TYPE, message, at, label));
        None
    };
    let Value::Array(items) = &member.node.value else {
        wrong(member.node.at, "an array", &member.node.value);
        return Vec::new();
    };
    let string = |item: &Node| match &item.value {
        Value::String(text) => Some((text.clone(), item.at)),
        other => wrong(item.at, "a string", other),
    };
    items.iter().filter_map(string).collect()
}
