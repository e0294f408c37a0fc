//! A comparison as text for a terminal, as Markdown for a changelog, as JSON for tools, and as messages for what shows
//! messages.

mod findings;
mod json;
mod markdown;
mod text;

pub use findings::{findings, rules};
pub use json::json;
pub use markdown::markdown;
pub use text::text;

use super::change::Change;
use super::changes::Comparison;
use crate::diagnostic::render::position;
use crate::source::{Location, Sources};

/// The places of both versions.
struct Places<'s> {
    old: &'s Sources,
    new: &'s Sources,
}

impl Places<'_> {
    /// Where the old version says what changes, and where the new one does: `devices/c887/device.toml:12:3`.
    fn of(&self, change: &Change) -> (Option<String>, Option<String>) {
        (written(self.old, change.old_at), written(self.new, change.new_at))
    }
}

fn written(sources: &Sources, at: Option<Location>) -> Option<String> {
    let at = at?;
    let file = sources.get(at.file)?;
    let (start, _) = position::range(at, sources);
    Some(format!("{}:{}:{}", file.path, start.line, start.column))
}

/// What a change makes of what: `UINT16 → INT16`; only one of them if the other is not there.
fn values(change: &Change, arrow: &str) -> String {
    match (&change.old, &change.new) {
        (Some(old), Some(new)) => format!("{} {arrow} {}", short(old), short(new)),
        (Some(old), None) => short(old),
        (None, Some(new)) => short(new),
        (None, None) => String::new(),
    }
}

/// Where else it changes alike: on how many axes, and in which devices if not in all; nothing if there is nothing to say.
fn range(comparison: &Comparison, change: &Change, before: &str) -> String {
    let mut range = String::new();
    if change.axes > 1 {
        range.push_str(&format!("{before}on {} axes", change.axes));
    }
    if change.devices.len() < comparison.devices.len() {
        let devices = change.devices.iter().filter_map(|number| comparison.devices.get(*number));
        let names: Vec<&str> = devices.map(|device| device.name.as_str()).collect();
        range.push_str(&format!("{before}of {}", names.join(", ")));
    }
    range
}

/// What fits a line.
fn short(value: &str) -> String {
    const MOST: usize = 60;
    let line = value.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(MOST) {
        None if line.is_empty() => "nothing".to_owned(),
        None => line,
        Some((end, _)) => format!("{}…", line.get(..end).unwrap_or_default()),
    }
}

/// The name of what changes, unless it is one of the values already.
fn named(change: &Change) -> Option<&str> {
    let is_value = |name: &&str| [&change.old, &change.new].into_iter().flatten().any(|value| value == name);
    change.name.as_deref().filter(|name| !is_value(name))
}
