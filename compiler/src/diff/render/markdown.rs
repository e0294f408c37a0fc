//! As a section of a changelog.

use super::{named, range, values};
use crate::diff::change::{Change, Class};
use crate::diff::changes::{Comparison, Versioned};
use crate::emit::markdown::escaped as escape;
use crate::text::characters::harmless;

/// A comparison as Markdown, ready for a changelog: what breaks somebody first. Changes that only people notice are
/// counted.
pub fn markdown(comparison: &Comparison) -> String {
    if comparison.changes.is_empty() {
        return "Nothing changes.\n".to_owned();
    }
    let mut out: String = comparison.devices.iter().map(heading).collect();
    for class in Class::ALL {
        let changes = comparison.changes.iter().filter(|change| change.kind.class == class);
        let lines: Vec<String> = changes.map(|change| line(comparison, change)).collect();
        match lines.len() {
            0 => {}
            count if class == Class::Documentation => {
                out.push_str(&format!("\n{}: {count}.\n", title(class)))
            }
            _ => out.push_str(&format!("\n### {}\n\n{}", title(class), lines.concat())),
        }
    }
    harmless(&out).into_owned()
}

fn heading(device: &Versioned) -> String {
    let name = escape(&device.name);
    match device.revisions {
        Some((old, new)) if old != new => format!("## {name}: revision `0x{old:08X}` to `0x{new:08X}`\n"),
        _ => format!("## {name}\n"),
    }
}

fn title(class: Class) -> &'static str {
    match class {
        Class::WireBreaking => "Breaks programs and projects",
        Class::ConfigurationBreaking => "Breaks configurations",
        Class::Compatible => "New",
        Class::Documentation => "Names, texts and sources",
    }
}

fn line(comparison: &Comparison, change: &Change) -> String {
    let name = named(change).map_or(String::new(), |name| format!(" {}", escape(name)));
    let range = escape(&range(comparison, change, " "));
    let range = if range.is_empty() { range } else { format!(" {range}") };
    let values = values(change, "to");
    let values = if values.is_empty() { values } else { format!(": {}", escape(&values)) };
    format!("- `{}`{name}{range}, {}{values}\n", change.at, change.kind.rule.summary)
}
