//! A decoded table with its key and its place.

use super::{RawEntry, RawFacts, RawObject};
use crate::source::Origin;

/// A table, what it was read into, and where it stands.
#[derive(Debug)]
pub struct Entity<T> {
    /// Its key in the section, or its number in a list.
    pub key: String,
    /// Where it was written.
    pub origin: Origin,
    /// What it says.
    pub raw: T,
    /// How sure that is.
    pub facts: RawFacts,
}

/// An object: the one kind of table that is read as two structs, holds tables of its own, and can differ
/// from axis to axis.
#[derive(Debug)]
pub struct ObjectEntity {
    /// What makes it an object.
    pub object: Entity<RawObject>,
    /// What its value is; for a record or array what all entries have in common.
    pub value: RawEntry,
    /// Its entries, in the order in which they were written.
    pub entries: Vec<Entity<RawEntry>>,
    /// The whole object as it is on some axes: the axes as written, and the object with what differs
    /// there laid over.
    pub per_axis: Vec<(String, ObjectEntity)>,
}
