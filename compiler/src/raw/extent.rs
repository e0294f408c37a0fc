//! How much a description asks to be read.
//!
//! Tables that are like another one, members of a family and objects that differ from axis to axis are read as if they
//! were written out. So a short text can stand for a long one, and what counts is the long one.

use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::source::{Location, Table};

/// How many bytes a description may be when it is written out.
const BYTES: usize = 64 << 20;

/// How many tables a section may have in which other tables are looked up and compared with each other.
const NAMED: usize = 1_024;

/// The sections that have codes and indices for keys, of which there can be as many as 16 bits tell apart.
const NUMBERED: [&str; 6] =
    ["objects", "errors", "vendor-codes", "registers", "al-status-codes", "parameters"];

/// Reports a section with more tables than it may have.
pub(super) fn judge_section(name: &str, section: &Table, diagnostics: &mut Diagnostics) {
    let beyond = section.members.get(NAMED).filter(|_| !NUMBERED.contains(&name));
    if let Some(beyond) = beyond {
        let message = format!("`[{name}]` has {} tables", section.members.len());
        let label = format!("it can have {NAMED}");
        diagnostics.push(Diagnostic::new(&faults::EXCEEDED_LIMIT, message, beyond.key.at, label));
    }
}

/// What is left of the bytes that a description may have.
pub(super) struct Room(usize);

impl Room {
    /// The room for a whole description.
    pub(super) fn new() -> Self {
        Self(BYTES)
    }

    /// Takes the room that a table needs several times, or reports that it is not there.
    pub(super) fn take(
        &mut self,
        table: &Table,
        times: usize,
        at: Location,
        diagnostics: &mut Diagnostics,
    ) -> bool {
        match self.0.checked_sub(table.members.weight().saturating_mul(times)) {
            Some(left) => {
                self.0 = left;
                true
            }
            None => {
                let message = "the description is too large when it is written out".to_owned();
                let label = "too much with what stands before";
                let fault = Diagnostic::new(&faults::EXCEEDED_LIMIT, message, at, label);
                diagnostics.push(fault.note(format!(
                    "it can have {} MiB; what members, tables that are `like` another and `per-axis` share counts for each",
                    BYTES >> 20
                )));
                false
            }
        }
    }

    /// Takes the room for a device: all its tables, and each object again for the axes on which it differs.
    pub(super) fn take_device(&mut self, tree: &Table, diagnostics: &mut Diagnostics) -> bool {
        if !self.take(tree, 1, tree.at, diagnostics) {
            return false;
        }
        let objects = tree.get("objects").and_then(|section| section.node.table());
        objects.into_iter().flat_map(|objects| &objects.members).all(|member| {
            let Some(object) = member.node.table() else { return true };
            let differing = object.get("per-axis").and_then(|axes| axes.node.table());
            differing.is_none_or(|axes| self.take(object, axes.members.len(), member.key.at, diagnostics))
        })
    }
}
