//! The values of all objects as structs.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::default;
use super::doc::Doc;
use super::literal;
use super::names::Names;
use super::scope::Scope;
use super::stored::{Shape, Stored, entry_doc, kept};
use super::{slots, table};
use crate::model::{Entry, Object};

/// What the module imports or declares beside the structs of records.
const RESERVED: &[&str] = &[
    "Access",
    "Axis",
    "AxisDictionary",
    "DataType",
    "Dictionary",
    "EntryInfo",
    "ObjectCode",
    "ObjectInfo",
    "Option",
    "Page",
];

pub(super) fn module(scope: &Scope<'_>) -> TokenStream {
    let runtime = scope.runtime;
    let mut names = Names::with(RESERVED);
    names.claim(&scope.marker);
    let stored = Stored::all(scope, &mut names);
    let (table, slots) = (table::items(scope, &stored), slots::items(scope, &stored));
    let records = stored.iter().filter_map(|object| record(scope, object));
    let (of_axis, of_device): (Vec<&Stored<'_>>, Vec<&Stored<'_>>) =
        stored.iter().partition(|object| object.is_of_axis());
    let device = device(scope, &of_device, &of_axis);
    let axis = (!of_axis.is_empty()).then(|| axis(scope, &of_axis));
    quote! {
        /// The object dictionary as a firmware keeps it: values with their defaults, and a table of all entries.
        pub mod dictionary {
            use super::*;
            use #runtime::sdo::{self, Access, DataType, EntryInfo, ObjectCode, ObjectInfo, Page, positions};
            #device
            #axis
            #(#records)*
            #slots
            #table
        }
    }
}

/// The struct of an object, if it has one of its own.
fn record(scope: &Scope<'_>, object: &Stored<'_>) -> Option<TokenStream> {
    let (ident, fields) = object.record()?;
    let fields = fields.map(|(entry, name)| {
        let (doc, value) = (entry_doc(scope, entry), kept(scope, entry).field());
        quote!(#doc pub #name: #value,)
    });
    let doc = &object.doc;
    Some(quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #ident { #(#fields)* }
    })
}

/// The default values on an axis, as an initialiser of the field.
fn default(scope: &Scope<'_>, stored: &Stored<'_>, object: &Object) -> TokenStream {
    let name = &stored.name;
    let mut values = stored.on(object).map(|(first, entry)| {
        let value = kept(scope, first);
        value.wrap(default::kept(entry, value.primitive))
    });
    match &stored.shape {
        Shape::Single => {
            let value = values.next();
            quote!(#name: #value,)
        }
        Shape::Array if are_alike(stored.on(object).map(|(_, entry)| entry)) => {
            let (value, count) = (values.next(), literal::number(stored.entries.len()));
            quote!(#name: [#value; #count],)
        }
        Shape::Array => quote!(#name: [#(#values),*],),
        Shape::List => {
            let count = values.next();
            quote!(#name: sdo::List { count: #count, items: [#(#values),*] },)
        }
        Shape::Record(ident, fields) => quote!(#name: #ident { #(#fields: #values),* },),
    }
}

/// Whether all have the same default.
fn are_alike<'a>(mut entries: impl Iterator<Item = &'a Entry>) -> bool {
    entries.next().is_none_or(|first| entries.all(|entry| entry.default == first.default))
}

fn fields(objects: &[&Stored<'_>]) -> TokenStream {
    let fields = objects.iter().map(|object| {
        let (doc, name, field) = (&object.doc, &object.name, &object.field);
        quote!(#doc pub #name: #field,)
    });
    fields.collect()
}

fn device(scope: &Scope<'_>, objects: &[&Stored<'_>], of_axis: &[&Stored<'_>]) -> TokenStream {
    let fields = fields(objects);
    let defaults = objects.iter().map(|object| default(scope, object, object.placed.first));
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
        quote!(#fields #axes),
        quote!(#(#defaults)* #axes_default),
    )
}

fn axis(scope: &Scope<'_>, objects: &[&Stored<'_>]) -> TokenStream {
    let fields = fields(objects);
    let defaults = objects.iter().map(|object| default(scope, object, object.placed.first));
    let name = format_ident!("AxisDictionary");
    let doc = "Every object of an axis whose value can change, by its index on the first axis.";
    structure(&name, doc, "The defaults of the first axis.", fields, quote!(#(#defaults)*))
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
    let count = scope.device.axes.len();
    let of_axes: Vec<Vec<TokenStream>> = (0..count).map(|axis| differing(scope, objects, axis)).collect();
    if of_axes.iter().all(Vec::is_empty) {
        let count = literal::number(count);
        return quote!(axes: [AxisDictionary::DEFAULT; #count],);
    }
    let axes = of_axes.iter().map(|differing| match differing.as_slice() {
        [] => quote!(AxisDictionary::DEFAULT),
        differing => quote!(AxisDictionary { #(#differing)* ..AxisDictionary::DEFAULT }),
    });
    quote!(axes: [#(#axes),*],)
}

/// The defaults that an axis has for itself.
fn differing(scope: &Scope<'_>, objects: &[&Stored<'_>], axis: usize) -> Vec<TokenStream> {
    let differs = |(first, entry): (&Entry, &Entry)| entry.default != first.default;
    let of_axis = objects.iter().filter_map(|stored| {
        let object = stored.placed.all.get(axis)?;
        stored.on(object).any(differs).then(|| default(scope, stored, object))
    });
    of_axis.collect()
}
