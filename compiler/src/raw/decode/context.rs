//! What is found on the way through a table.

use std::cell::RefCell;

use super::error::Error;
use crate::diagnostic::{Diagnostic, faults};
use crate::source::{Key, Location, Table};
use crate::text::near::{list, near};

/// What the values of one table have found out so far.
#[derive(Debug, Default)]
pub(super) struct Context {
    found: RefCell<Vec<Diagnostic>>,
    /// The keys that the structs read from the outermost table know; none if it was not read as a struct.
    top: RefCell<Vec<&'static str>>,
    /// The tables in which a key was probably misspelled, with the key that was meant.
    meant: RefCell<Vec<(Location, &'static str)>>,
}

impl Context {
    /// Notes what a struct that is read from the outermost table knows.
    pub(super) fn know(&self, fields: &[&'static str]) {
        let mut top = self.top.borrow_mut();
        for field in fields {
            if !top.contains(field) {
                top.push(field);
            }
        }
    }

    /// Judges the keys of the outermost table, when all of its structs are known.
    pub(super) fn judge_top(&self, table: &Table) {
        let top = self.top.borrow();
        if !top.is_empty() {
            self.judge(table, table.at, &top);
        }
    }

    /// Reports the keys of a table that are not among those known.
    pub(super) fn judge(&self, table: &Table, at: Location, known: &[&'static str]) {
        let is_free = |name: &&str| table.get(name).is_none();
        for member in table.members.iter().filter(|member| !known.contains(&&*member.key.name)) {
            let meant = near(&member.key.name, known.iter().copied().filter(is_free));
            self.meant.borrow_mut().extend(meant.map(|name| (at, name)));
            self.found.borrow_mut().push(report(&member.key, meant, known));
        }
    }

    /// Whether the error is about a key that is there, but misspelled.
    pub(super) fn explains(&self, error: &Error) -> bool {
        error.is_missing(&self.meant.borrow())
    }

    /// The findings, in the order of finding.
    pub(super) fn found(self) -> Vec<Diagnostic> {
        self.found.into_inner()
    }
}

/// That a key is none of those that its table may have.
pub(crate) fn unknown_key(key: &Key, known: &[&'static str]) -> Diagnostic {
    report(key, near(&key.name, known.iter().copied()), known)
}

fn report(key: &Key, meant: Option<&str>, known: &[&'static str]) -> Diagnostic {
    let message = format!("unknown key `{}`", key.name);
    let diagnostic = Diagnostic::new(&faults::UNKNOWN_KEY, message, key.at, "not a key of this table");
    match meant {
        Some(name) => diagnostic.fix(format!("did you mean `{name}`?"), key.at, name),
        None => diagnostic.note(format!("its keys are {}", list(known))),
    }
}
