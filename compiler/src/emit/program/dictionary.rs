//! The object dictionary by name.

use serde::Serialize;

use super::names::Names;
use crate::emit::escape::prose;
use crate::model::{Device, Object as Described};

/// An object.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Object {
    pub(in crate::emit) index: u16,
    pub(in crate::emit) name: String,
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
    /// The entries behind subindex 0.
    pub(in crate::emit) entries: Vec<Entry>,
}

/// An entry of an object.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Entry {
    pub(in crate::emit) subindex: u8,
    pub(in crate::emit) name: String,
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
}

/// The objects by index. Where there are several axes, the name tells which.
pub(super) fn objects(device: &Device, names: &mut Names) -> Vec<Object> {
    let mut siblings = names.siblings();
    let object = |of: &Described| {
        let axis = of.axis.filter(|_| device.axes.len() > 1);
        let axis = axis.and_then(|axis| device.axes.get(usize::from(axis))).map_or("", |axis| &axis.name);
        let name = siblings.claim(&format!("{axis}-{}", of.id));
        let mut inner = names.siblings();
        // those of mapping and assignment are numbers in order
        let told = of.entries.iter().filter(|entry| entry.address.subindex > 0 && !of.derived);
        let entries = told.map(|entry| Entry {
            subindex: entry.address.subindex,
            name: inner.claim(&entry.id),
            global: names.global(&["sub", axis, &of.id, &entry.id]),
            title: prose(&entry.name),
        });
        let entries = entries.collect();
        let global = names.global(&["od", axis, &of.id]);
        Object { index: of.index.0, name, global, title: prose(&device.on_axis(&of.name, of.axis)), entries }
    };
    device.objects.iter().map(object).collect()
}
