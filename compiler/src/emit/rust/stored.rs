//! The objects whose values can change, and how each is kept in a field.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::axes::Placed;
use super::doc::{Doc, sentence};
use super::entry;
use super::literal;
use super::names::{Names, camel, snake};
use super::scope::Scope;
use super::types::{Primitive, ValueType};
use crate::model::{DataType, Entry, Index, Kind, Object};

/// An object whose values can change.
pub(super) struct Stored<'a> {
    pub(super) placed: &'a Placed<'a, Object>,
    /// The number of its field: those of the device first, then those of an axis.
    pub(super) number: u16,
    pub(super) name: Ident,
    /// The type of the field.
    pub(super) field: TokenStream,
    pub(super) doc: Doc,
    pub(super) shape: Shape,
    /// The entries of the first axis that are kept.
    pub(super) entries: Vec<&'a Entry>,
}

/// How the values of an object are kept.
pub(super) enum Shape {
    Single,
    /// Values of one type from subindex 1 on.
    Array,
    /// Values of one type, and before them how many of them are in use.
    List,
    /// A struct of this name, with these fields.
    Record(Ident, Vec<Ident>),
}

impl<'a> Stored<'a> {
    /// All of them, in the order of their fields.
    pub(super) fn all(scope: &'a Scope<'a>, names: &mut Names) -> Vec<Self> {
        let of = |is_of_axis: bool| {
            scope.objects.iter().filter(move |object| object.shift.is_some() == is_of_axis)
        };
        let stored = of(false).chain(of(true)).filter_map(|object| Stored::of(scope, object, names));
        stored.zip(0..).map(|(stored, number)| Self { number, ..stored }).collect()
    }

    fn of(scope: &Scope<'_>, placed: &'a Placed<'a, Object>, names: &mut Names) -> Option<Self> {
        let object = placed.first;
        let entries = changeable(scope, object);
        let (first, more) = entries.split_first()?;
        let name = snake(&placed.id);
        if object.kind == Kind::Var && more.is_empty() {
            let (doc, field) = (entry_doc(scope, first), kept(scope, first).field());
            return Some(Self { placed, number: 0, name, field, doc, shape: Shape::Single, entries });
        }
        let doc = Doc::new(format!("`{}` {}", object.index, sentence(&object.name)));
        if is_array(scope, object, &entries) {
            let (item, count) = (kept(scope, first).field(), literal::number(entries.len()));
            let doc = doc.lines(entries.iter().map(|entry| list_item(scope, entry)));
            let field = quote!([#item; #count]);
            return Some(Self { placed, number: 0, name, field, doc, shape: Shape::Array, entries });
        }
        if let Some(item) = more.first().filter(|_| is_list(object, &entries)) {
            let doc = doc.text(&entry::facts(scope, first, None));
            let (item, count) = (kept(scope, item).field(), literal::number(more.len()));
            let field = quote!(sdo::List<#item, #count>);
            return Some(Self { placed, number: 0, name, field, doc, shape: Shape::List, entries });
        }
        let ident = names.claim(&camel(&placed.id));
        let mut names = Names::default();
        let fields = entries.iter().map(|entry| names.claim(&snake(&entry.id))).collect();
        let (field, shape) = (quote!(#ident), Shape::Record(ident, fields));
        Some(Self { placed, number: 0, name, field, doc, shape, entries })
    }

    /// Each entry that is kept, of the first axis and of this object, which is that of another axis or the same.
    pub(super) fn on<'b>(&'b self, object: &'b Object) -> impl Iterator<Item = (&'b Entry, &'b Entry)> {
        self.entries.iter().map(|first| (*first, object.entry(first.address.subindex).unwrap_or(first)))
    }

    /// The subindices that are kept.
    pub(super) fn subindices(&self) -> String {
        let kept = self.entries.iter().map(|entry| entry.address.subindex.to_string());
        kept.collect::<Vec<_>>().join(" ")
    }

    /// Whether each axis has it.
    pub(super) fn is_of_axis(&self) -> bool {
        self.placed.shift.is_some()
    }

    /// The fields of its record with their entries, if it is one.
    pub(super) fn record(&self) -> Option<(&Ident, impl Iterator<Item = (&'a Entry, &Ident)>)> {
        match &self.shape {
            Shape::Record(name, fields) => Some((name, self.entries.iter().copied().zip(fields))),
            Shape::Single | Shape::Array | Shape::List => None,
        }
    }
}

/// Where the values of an object are.
#[derive(Debug, Clone)]
pub(super) struct Home {
    /// The number of the field.
    pub(super) field: u16,
    /// The axis; none for an object of the device.
    pub(super) axis: Option<u8>,
    /// The subindices that are kept there.
    pub(super) subindices: Vec<u8>,
}

/// Where the values of each object are that has any which can change.
pub(super) fn homes(stored: &[Stored<'_>]) -> BTreeMap<Index, Home> {
    let mut homes = BTreeMap::new();
    for stored in stored {
        let subindices: Vec<u8> = stored.entries.iter().map(|entry| entry.address.subindex).collect();
        for (object, axis) in stored.placed.all.iter().zip(0..=u8::MAX) {
            let axis = stored.is_of_axis().then_some(axis);
            homes.insert(object.index, Home { field: stored.number, axis, subindices: subindices.clone() });
        }
    }
    homes
}

/// The type in which the value of an entry is kept: a text that can be written needs its bytes.
pub(super) fn kept(scope: &Scope<'_>, entry: &Entry) -> ValueType {
    let value = scope.types.at(Some(entry.address), entry.data_type);
    match value.primitive {
        Primitive::Text if entry.access.writable() => {
            ValueType { primitive: Primitive::Bytes(entry.data_type.bytes()), newtype: None }
        }
        _ => value,
    }
}

/// Address, name and facts of an entry.
pub(super) fn entry_doc(scope: &Scope<'_>, entry: &Entry) -> Doc {
    Doc::new(format!("{} {}", entry::title(entry), entry::facts(scope, entry, None)))
}

fn list_item(scope: &Scope<'_>, entry: &Entry) -> String {
    let name = sentence(&entry.name);
    format!("- `{:02X}` {} {}", entry.address.subindex, name, entry::facts(scope, entry, None))
}

/// The entries that have to be kept.
fn changeable<'a>(scope: &Scope<'_>, object: &'a Object) -> Vec<&'a Entry> {
    object.entries.iter().filter(|entry| scope.device.keeps(object, entry)).collect()
}

/// Whether the values have one type and no gaps.
fn is_array(scope: &Scope<'_>, object: &Object, entries: &[&Entry]) -> bool {
    let Some(first) = entries.first() else { return false };
    object.kind == Kind::Array
        && entries.iter().zip(1..=u8::MAX).all(|(entry, subindex)| entry.address.subindex == subindex)
        && entries.iter().all(|entry| kept(scope, entry) == kept(scope, first))
}

/// Whether the values are what process data is made of, after their number, all of which can change.
fn is_list(object: &Object, entries: &[&Entry]) -> bool {
    let (Some(count), Some(first)) = (entries.first(), entries.get(1)) else { return false };
    let rights = |entry: &Entry| (entry.access, entry.written, entry.pdo);
    object.derived
        && count.data_type == DataType::Uint(8)
        && entries.iter().zip(0..=u8::MAX).all(|(entry, subindex)| entry.address.subindex == subindex)
        && entries.iter().all(|entry| rights(entry) == rights(count) && entry.values.is_empty())
        && entries.iter().skip(1).all(|entry| entry.data_type == first.data_type)
}
