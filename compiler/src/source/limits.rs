//! How large a description may be: far above what any drive needs, and low enough that no description takes long to
//! refuse.
//!
//! What is within these limits, the rest of the compiler has to answer in time that grows with the size of the input.

use super::{Location, Node, Table, Value};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};

/// How deep tables and arrays may lie in one another.
pub(super) const NESTING: usize = 32;

/// How many files may belong to one description.
pub(super) const FILES: usize = 1_000;

/// How many bytes a key may have.
const KEY: usize = 255;

/// How many bytes a string may have.
const TEXT: usize = 1 << 16;

/// How many elements an array may have.
const ARRAY: usize = 4_096;

/// Where a table lies, which says how many keys it may have.
#[derive(Clone, Copy)]
enum Place {
    /// The file, or a member of a family: its keys are sections.
    Top,
    /// `[members]`.
    Family,
    /// A section: codes and indices of 16 bits.
    Section,
    /// A table within a section.
    Inside,
}

impl Place {
    fn within(self, key: &str) -> Self {
        match self {
            Self::Top if key == "members" => Self::Family,
            Self::Top => Self::Section,
            Self::Family => Self::Top,
            Self::Section | Self::Inside => Self::Inside,
        }
    }

    fn keys(self) -> usize {
        match self {
            Self::Top | Self::Family => 256,
            Self::Section => 1 << 16,
            Self::Inside => 4_096,
        }
    }
}

/// Reports each table and array that is too large, at the first of what is too much in it.
pub(super) fn check(root: &Table, diagnostics: &mut Diagnostics) {
    table(root, Place::Top, diagnostics);
}

fn table(table: &Table, place: Place, diagnostics: &mut Diagnostics) {
    let (count, limit) = (table.members.len(), place.keys());
    if let Some(beyond) = table.members.get(limit) {
        let (message, label) = match place {
            Place::Family => {
                (format!("{count} members of a family are too many"), format!("a family can have {limit}"))
            }
            _ => (
                format!("{count} keys in one table are too many"),
                format!("a table like this can have {limit}"),
            ),
        };
        diagnostics.push(exceeded(message, beyond.key.at, label));
    }
    for member in &table.members {
        node(&member.node, place.within(&member.key.name), diagnostics);
    }
}

fn node(node: &Node, place: Place, diagnostics: &mut Diagnostics) {
    match &node.value {
        Value::Table(inner) => table(inner, place, diagnostics),
        Value::Array(items) => {
            if let Some(beyond) = items.get(ARRAY) {
                let message = format!("{} elements of one array are too many", items.len());
                diagnostics.push(exceeded(message, beyond.at, format!("an array can have {ARRAY}")));
            }
            items.iter().for_each(|item| self::node(item, Place::Inside, diagnostics));
        }
        _ => {}
    }
}

/// That a key is too long, if it is.
pub(super) fn key(name: &str, at: Location) -> Option<Diagnostic> {
    let message = || format!("a key of {} bytes is too long", name.len());
    (name.len() > KEY).then(|| exceeded(message(), at, format!("a key can have {KEY} bytes")))
}

/// That a string is too long, if it is.
pub(super) fn text(text: &str, at: Location) -> Option<Diagnostic> {
    let message = || format!("a text of {} bytes is too long", text.len());
    (text.len() > TEXT).then(|| exceeded(message(), at, format!("a text can have {TEXT} bytes")))
}

/// That the description has more files than it may.
pub(super) fn includes(at: Location) -> Diagnostic {
    let message = "the description includes too many files".to_owned();
    exceeded(message, at, format!("a description can have {FILES}"))
}

/// That tables and arrays lie too deep in one another.
pub(super) fn nesting(at: Location) -> Diagnostic {
    let message = format!("tables and arrays lie more than {NESTING} deep in one another");
    Diagnostic::new(&faults::EXCEEDED_LIMIT, message, at, "too deep").note("the format needs no more than 10")
}

fn exceeded(message: String, at: Location, label: String) -> Diagnostic {
    Diagnostic::new(&faults::EXCEEDED_LIMIT, message, at, label)
}
