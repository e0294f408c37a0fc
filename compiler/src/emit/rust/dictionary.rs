//! The values of all objects as structs, and the table to look them up in.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::axes::Placed;
use super::doc::Doc;
use super::entry;
use super::literal;
use super::names::{Names, camel, snake};
use super::scope::Scope;
use super::table;
use crate::model::{Access, DataType, Entry, Kind, Object, Provenance};

pub(super) fn module(scope: &Scope<'_>) -> TokenStream {
    let (runtime, table) = (scope.runtime, table::items(scope));
    let mut names = Names::with(&["Dictionary", "AxisDictionary", "Axis", scope.marker.to_string().as_str()]);
    let stored: Vec<Stored<'_>> =
        scope.objects.iter().filter_map(|object| Stored::of(scope, object, &mut names)).collect();
    let records = stored.iter().filter_map(|object| object.record.as_ref());
    let (of_axis, of_device): (Vec<&Stored<'_>>, Vec<&Stored<'_>>) =
        stored.iter().partition(|object| object.placed.shift.is_some());
    let device = device(scope, &of_device, &of_axis);
    let axis = (!of_axis.is_empty()).then(|| axis(scope, &of_axis));
    quote! {
        /// The object dictionary as a firmware keeps it: values with their defaults, and a table of all entries.
        pub mod dictionary {
            use super::*;
            use #runtime::sdo::{Access, DataType, EntryInfo, ObjectCode, ObjectInfo, Page, positions};
            #device
            #axis
            #(#records)*
            #table
        }
    }
}

/// An object whose values can change.
struct Stored<'a> {
    placed: &'a Placed<'a, Object>,
    name: Ident,
    field: TokenStream,
    /// The declaration of its type, if it has one of its own.
    record: Option<TokenStream>,
    shape: Shape,
}

/// How the values of an object are kept.
enum Shape {
    Single,
    /// Values of one type from subindex 1 on.
    Array,
    /// A struct of this name, with these fields.
    Record(Ident, Vec<Ident>),
}

impl<'a> Stored<'a> {
    fn of(scope: &Scope<'_>, placed: &'a Placed<'a, Object>, names: &mut Names) -> Option<Self> {
        let object = placed.first;
        let entries = changeable(object);
        let (first, more) = entries.split_first()?;
        let name = snake(&placed.id);
        let value = |entry: &Entry| scope.types.at(Some(entry.address), entry.data_type).field();
        if object.kind == Kind::Var && more.is_empty() {
            let doc = title(scope, first);
            let field = value(first);
            return Some(Self {
                placed,
                field: quote!(#doc pub #name: #field,),
                name,
                record: None,
                shape: Shape::Single,
            });
        }
        let doc = Doc::new(format!("`{}` {}", object.index, super::doc::sentence(&object.name)));
        if is_array(scope, object, &entries) {
            let (item, count) = (value(first), literal::number(entries.len()));
            let doc = doc.lines(entries.iter().map(|entry| list_item(scope, entry)));
            let field = quote!(#doc pub #name: [#item; #count],);
            return Some(Self { placed, field, name, record: None, shape: Shape::Array });
        }
        let ident = names.claim(&camel(&placed.id));
        let (record, fields) = record(scope, &ident, &doc, &entries);
        let field = quote!(#doc pub #name: #ident,);
        Some(Self { placed, field, name, record: Some(record), shape: Shape::Record(ident, fields) })
    }

    /// The default values on an axis, as an initialiser of the field.
    fn default(&self, scope: &Scope<'_>, object: &Object) -> TokenStream {
        let (name, firsts) = (&self.name, changeable(self.placed.first));
        let mut values = firsts.iter().map(|first| {
            let entry = object.entry(first.address.subindex).unwrap_or(first);
            scope.types.at(Some(first.address), entry.data_type).wrap(literal::value(entry))
        });
        match &self.shape {
            Shape::Single => {
                let value = values.next();
                quote!(#name: #value,)
            }
            Shape::Array => {
                let values: Vec<TokenStream> = values.collect();
                let count = literal::number(values.len());
                match values.split_first() {
                    Some((first, rest))
                        if rest.iter().all(|value| value.to_string() == first.to_string()) =>
                    {
                        quote!(#name: [#first; #count],)
                    }
                    _ => quote!(#name: [#(#values),*],),
                }
            }
            Shape::Record(ident, fields) => quote!(#name: #ident { #(#fields: #values),* },),
        }
    }
}

/// The entries that have to be kept: not those that never change, by their access or because they follow from the
/// PDOs or from the number of entries.
fn changeable(object: &Object) -> Vec<&Entry> {
    let fixed = |entry: &Entry| {
        entry.access == Access::Const
            || (entry.access == Access::Ro && entry.type_provenance == Provenance::Derived)
            || entry.access == Access::Ro && matches!(entry.data_type, DataType::Text(0))
    };
    object.entries.iter().filter(|entry| !fixed(entry)).collect()
}

/// Whether the values have one type and no gaps.
fn is_array(scope: &Scope<'_>, object: &Object, entries: &[&Entry]) -> bool {
    let value = |entry: &Entry| scope.types.at(Some(entry.address), entry.data_type).field().to_string();
    let Some(first) = entries.first() else { return false };
    object.kind == Kind::Array
        && entries.iter().zip(1..=u8::MAX).all(|(entry, subindex)| entry.address.subindex == subindex)
        && entries.iter().all(|entry| value(entry) == value(first))
}

fn record(scope: &Scope<'_>, ident: &Ident, doc: &Doc, entries: &[&Entry]) -> (TokenStream, Vec<Ident>) {
    let mut names = Names::default();
    let idents: Vec<Ident> = entries.iter().map(|entry| names.claim(&snake(&entry.id))).collect();
    let fields = entries.iter().zip(&idents).map(|(entry, name)| {
        let doc = Doc::new(format!("{} {}", entry::title(entry), entry::facts(scope, entry, None)));
        let value = scope.types.at(Some(entry.address), entry.data_type).field();
        quote!(#doc pub #name: #value,)
    });
    let record = quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #ident { #(#fields)* }
    };
    (record, idents)
}

fn title(scope: &Scope<'_>, entry: &Entry) -> Doc {
    Doc::new(format!("{} {}", entry::title(entry), entry::facts(scope, entry, None)))
}

fn list_item(scope: &Scope<'_>, entry: &Entry) -> String {
    let name = super::doc::sentence(&entry.name);
    format!("- `{:02X}` {} {}", entry.address.subindex, name, entry::facts(scope, entry, None))
}

fn device(scope: &Scope<'_>, objects: &[&Stored<'_>], of_axis: &[&Stored<'_>]) -> TokenStream {
    let fields = objects.iter().map(|object| &object.field);
    let defaults = objects.iter().map(|object| object.default(scope, object.placed.first));
    let count = literal::number(scope.device.axes.len());
    let doc = Doc::new("What each axis has, in order.");
    let axes = (!of_axis.is_empty()).then(|| quote!(#doc pub axes: [AxisDictionary; #count],));
    let axes_default = (!of_axis.is_empty()).then(|| axes_default(scope, of_axis));
    let name = format_ident!("Dictionary");
    let doc = "Every object whose value can change.";
    structure(
        &name,
        doc,
        "The values that the manual gives as defaults, 0 where it gives none.",
        quote!(#(#fields)* #axes),
        quote!(#(#defaults)* #axes_default),
    )
}

fn axis(scope: &Scope<'_>, objects: &[&Stored<'_>]) -> TokenStream {
    let fields = objects.iter().map(|object| &object.field);
    let defaults = objects.iter().map(|object| object.default(scope, object.placed.first));
    let name = format_ident!("AxisDictionary");
    let doc = "Every object of an axis whose value can change, by its index on the first axis.";
    structure(&name, doc, "The defaults of the first axis.", quote!(#(#fields)*), quote!(#(#defaults)*))
}

fn structure(
    name: &Ident,
    doc: &str,
    default_doc: &str,
    fields: TokenStream,
    defaults: TokenStream,
) -> TokenStream {
    let (doc, default_doc) = (Doc::new(doc), Doc::new(default_doc));
    quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #name { #fields }

        impl #name {
            #default_doc
            pub const DEFAULT: Self = Self { #defaults };
        }

        impl Default for #name {
            fn default() -> Self {
                Self::DEFAULT
            }
        }
    }
}

/// The defaults of all axes, of which only those that differ from the first axis are written out.
fn axes_default(scope: &Scope<'_>, objects: &[&Stored<'_>]) -> TokenStream {
    let axes: Vec<TokenStream> = (0..scope.device.axes.len())
        .map(|axis| {
            let differing = objects.iter().filter_map(|object| {
                let here = object.default(scope, object.placed.all.get(axis)?);
                (here.to_string() != object.default(scope, object.placed.first).to_string()).then_some(here)
            });
            let differing: Vec<TokenStream> = differing.collect();
            if differing.is_empty() {
                quote!(AxisDictionary::DEFAULT)
            } else {
                quote!(AxisDictionary { #(#differing)* ..AxisDictionary::DEFAULT })
            }
        })
        .collect();
    let first = quote!(AxisDictionary::DEFAULT);
    if axes.iter().all(|axis| axis.to_string() == first.to_string()) {
        let count = literal::number(axes.len());
        return quote!(axes: [#first; #count],);
    }
    quote!(axes: [#(#axes),*],)
}
