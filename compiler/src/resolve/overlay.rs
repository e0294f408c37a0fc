//! What a description says of an object that devc makes.

use super::context::Context;
use super::{entries, facts, keys};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Entry, Object};
use crate::raw::{Entity, ObjectEntity, RawEntry};

/// Lays names, notes and times of writing over a derived object; what it consists of stays.
pub(super) fn apply(context: &mut Context<'_>, object: &mut Object, overlay: ObjectEntity) {
    let ObjectEntity { object: head, value, entries: described, per_axis: _ } = overlay;
    if let Some(id) = head.raw.id {
        object.id = id;
    }
    if let Some(name) = &value.name {
        object.name.clone_from(name);
    }
    object.about = value.about.clone().or(object.about.take());
    object.note = value.note.clone().or(object.note.take());
    object.source = facts::source(context, &head.facts).or(object.source.take());
    for entry in &mut object.entries {
        shared(entry, &value);
    }
    for raw in described {
        own(context, object, raw);
    }
    object.origin = head.origin;
}

/// What holds for all entries.
fn shared(entry: &mut Entry, value: &RawEntry) {
    if value.access.is_some() {
        entry.access = entries::access(value.access);
    }
    entry.written = value.written.clone().or(entry.written.take());
}

/// What holds for one entry.
fn own(context: &mut Context<'_>, object: &mut Object, raw: Entity<RawEntry>) {
    let Some(range) = keys::range::<u8>(&raw.key) else {
        context.invalid(&raw.key, "a subindex from 0 to 255", raw.origin.header());
        return;
    };
    for subindex in range {
        let Some(entry) = object.entries.iter_mut().find(|entry| entry.address.subindex == subindex) else {
            let message = format!("{} has no subindex {subindex}", object.index);
            let fault =
                Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, raw.origin.header(), "not there");
            let from = "its entries follow from `[rx-pdos]`, `[tx-pdos]` and `[sync-managers]`";
            context.diagnostics.push(fault.note(from));
            continue;
        };
        shared(entry, &raw.raw);
        entry.name = raw.raw.name.clone().unwrap_or_else(|| entry.name.clone());
        entry.about = raw.raw.about.clone().or(entry.about.take());
        entry.note = raw.raw.note.clone().or(entry.note.take());
        // What is made stays; a rule compares it with what is written.
        if raw.raw.default.is_some() {
            entry.origin = raw.origin.clone();
        }
    }
}
