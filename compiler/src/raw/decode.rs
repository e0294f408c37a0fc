//! Tables to the structs of the format.
//!
//! A [`Deserializer`](serde::Deserializer) of our own, because serde's way of reading TOML loses what people
//! need: it reports one fault a file where this reports one a table, each at its very value, and it knows only
//! one unknown key, or none, where this finds them all. The keys that a table may have are those of its
//! structs, as serde hands them over, so that there is no second list.

mod access;
mod context;
mod error;
mod keys;
#[cfg(test)]
mod tests;
mod view;

use serde::Deserialize;

use crate::diagnostic::Diagnostics;
use crate::source::Table;
use context::Context;
pub(crate) use context::unknown_key;
use error::Error;
pub(crate) use keys::keys;
use view::View;

/// Reads one table as one struct, or as several, each of which takes the keys that it knows.
pub(crate) struct Reader<'t, 'd> {
    table: &'t Table,
    context: Context,
    errors: Vec<Error>,
    diagnostics: &'d mut Diagnostics,
}

impl<'t, 'd> Reader<'t, 'd> {
    /// A reader that has not read anything.
    pub(crate) fn new(table: &'t Table, diagnostics: &'d mut Diagnostics) -> Self {
        Self { table, context: Context::default(), errors: Vec::new(), diagnostics }
    }

    /// What one of the structs takes; none if a value does not fit.
    pub(crate) fn part<T: Deserialize<'t>>(&mut self) -> Option<T> {
        let value = T::deserialize(View::top(self.table, &self.context));
        value.map_err(|error| self.errors.push(error)).ok()
    }

    /// Reports the first value that did not fit each struct, and every key that none of them knows.
    pub(crate) fn finish(self) {
        self.context.judge_top(self.table);
        // A key that is missing because it was misspelled is not worth a second message.
        let errors = self.errors.into_iter().filter(|error| !self.context.explains(error));
        let errors: Vec<_> = errors.map(Error::into_diagnostic).collect();
        self.diagnostics.extend(self.context.found());
        self.diagnostics.extend(errors);
    }
}
