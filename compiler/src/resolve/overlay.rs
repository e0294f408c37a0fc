//! What a description says of an object that devc makes.

use super::context::Context;
use super::entries::{Known, entry};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Entry, Object, WriteWindow};
use crate::raw::{RawEntries, RawEntry, RawObject, RawObjectHead};
use crate::source::Location;

/// Lays what is said over a made object. What it consists of follows from the PDOs and the sync managers: a statement
/// about that is compared, or answered here.
pub(super) fn apply(context: &mut Context<'_>, object: &mut Object, raw: RawObject) {
    let RawObject { key: _, index: _, head, value, entries, shared, per_axis, source, origin } = raw;
    let RawObjectHead { id, kind, entries: _, sdo_access, per_axis: _ } = head;
    if kind.is_some_and(|kind| kind != object.kind) {
        follows(context, object, "what it is made of", origin.value("kind"));
    }
    if !per_axis.is_empty() {
        follows(context, object, "what it is on each axis", origin.value("per-axis"));
    }
    for entry in &mut object.entries {
        match entry.address.subindex {
            0 => count(entry, &shared.value),
            _ => own(context, entry, &shared),
        }
    }
    for described in &entries {
        describe(context, object, described);
    }
    object.id = id.unwrap_or_else(|| object.id.clone());
    object.name = value.name.unwrap_or_else(|| object.name.clone());
    object.names = value.names;
    object.category = value.category.unwrap_or(object.category);
    object.about = value.about;
    object.note = value.note;
    object.functional = value.functional.unwrap_or(true);
    object.parameter = value.parameter;
    object.properties = value.properties;
    object.sdo_access = sdo_access;
    object.source = source.or(object.source.take());
    object.origin = origin;
}

/// Reports a statement about what follows from other tables.
fn follows(context: &mut Context<'_>, object: &Object, what: &str, at: Location) {
    let message = format!("{what} cannot be said of {}", object.index);
    let fault = Diagnostic::new(&faults::UNFIT_VALUE, message, at, "leave it out");
    context.diagnostics.push(fault.note(FROM));
}

const FROM: &str = "it follows from `[rx-pdos]`, `[tx-pdos]` and `[sync-managers]`";

/// What holds for subindex 0, too, if it is said of the whole object.
fn count(entry: &mut Entry, shared: &RawEntry) {
    entry.written = written(entry, shared);
    entry.access = shared.access.unwrap_or(entry.access);
    entry.functional = shared.functional.unwrap_or(entry.functional);
}

/// When an entry is written: as is said, or as it was made if it still can be written.
fn written(made: &Entry, said: &RawEntry) -> Option<WriteWindow> {
    let access = said.access.unwrap_or(made.access);
    said.written.or(made.written.filter(|_| access.writable()))
}

/// What is said of some entries.
fn describe(context: &mut Context<'_>, object: &mut Object, raw: &RawEntries) {
    let (first, last) = raw.range;
    for subindex in first..=last {
        match object.entries.iter_mut().find(|entry| entry.address.subindex == subindex) {
            Some(entry) => own(context, entry, raw),
            None => {
                let message = format!("{} has no subindex {subindex:02X}", object.index);
                let at = raw.origin.header();
                let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "not there");
                context.diagnostics.push(fault.note(FROM));
            }
        }
    }
}

/// What is said of one entry; its type and its default stay what they are. A rule compares the default.
fn own(context: &mut Context<'_>, made: &mut Entry, raw: &RawEntries) {
    let name = raw.value.name.clone().unwrap_or_else(|| made.name.clone());
    let known = Known { address: made.address, name: &name, data_type: Some(made.data_type), many: raw.many };
    let Some(said) = entry(context, known, &raw.value, &raw.origin) else { return };
    if said.data_type != made.data_type {
        let message =
            format!("{} is said to be {}, but it is {}", made.address, said.data_type, made.data_type);
        let fault = Diagnostic::new(&faults::UNFIT_VALUE, message, raw.origin.value("type"), "leave it out");
        context.diagnostics.push(fault.note(FROM));
    }
    *made = Entry {
        id: made.id.clone(),
        data_type: made.data_type,
        default: made.default.take(),
        access: raw.value.access.unwrap_or(made.access),
        category: raw.value.category.unwrap_or(made.category),
        about: said.about.or(made.about.take()),
        note: said.note.or(made.note.take()),
        written: written(made, &raw.value),
        source: raw.source.clone(),
        ..said
    };
}
