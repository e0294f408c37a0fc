//! Values that are written to entries, by a configuration or by a person.

use super::context::Context;
use super::{objects, values};
use crate::model::{Entry, Literal, Object, Value};
use crate::source::Location;

/// The entry that is written to, or a report that there is none.
pub(super) fn target<'o>(
    context: &mut Context<'_>,
    text: &str,
    objects: &'o [Object],
    at: Location,
) -> Option<&'o Entry> {
    let address = context.address(text, at)?;
    let object = objects::at(objects, address.index)?;
    let entry = object.entry(address.subindex);
    if entry.is_none() {
        context.no_entry(object, address, at);
    }
    entry
}

/// The value that is written to an entry, or a report that it does not fit.
pub(super) fn value(
    context: &mut Context<'_>,
    literal: &Literal,
    entry: &Entry,
    at: Location,
) -> Option<Value> {
    values::value(context, literal, entry.data_type, [at, entry.origin.value("type")])
}
