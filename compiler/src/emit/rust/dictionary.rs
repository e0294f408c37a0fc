//! The values of all objects as structs.

use std::rc::Rc;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::default;
use super::doc::Doc;
use super::item::{Item, Reach, Space};
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

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let mut names = Names::with(RESERVED);
    names.claim(&scope.marker);
    let stored = Rc::new(Stored::all(scope, &mut names));
    let table = table::items(scope, &stored);
    let records = (0..stored.len()).filter_map(|place| record(scope, &stored, place)).collect::<Vec<_>>();
    let values = Item::new(format_ident!("Dictionary"), move || (Doc::default(), values(scope, &stored)));
    [values.reaching(Reach::Own)].into_iter().chain(records).chain(table).collect()
}

/// The structs of all values, and what a server asks of them.
fn values(scope: &Scope<'_>, stored: &[Stored<'_>]) -> TokenStream {
    let (of_axis, of_device): (Vec<&Stored<'_>>, Vec<&Stored<'_>>) =
        stored.iter().partition(|object| object.is_of_axis());
    let (device, server) = (device(scope, &of_device, &of_axis), slots::items(scope, stored));
    let axis = (!of_axis.is_empty()).then(|| axis(scope, &of_axis));
    quote!(#device #axis #server)
}

/// The struct of an object, if it has one of its own.
fn record<'s>(scope: &'s Scope<'_>, stored: &Rc<Vec<Stored<'s>>>, place: usize) -> Option<Item<'s>> {
    let object = stored.get(place)?;
    let (name, fields) = object.record()?;
    let entries: Vec<&'s Entry> = fields.map(|(entry, _)| entry).collect();
    let shared = Rc::clone(stored);
    let item = Item::new(name.clone(), move || {
        shared.get(place).and_then(|object| structure_of(scope, object)).unwrap_or_default()
    });
    let item = item.of(object.placed.first).told(object.subindices());
    Some(item.each(entries, |item, entry| {
        let unit = entry.unit.as_ref().and_then(|id| scope.device.unit(id));
        let item = item.each(unit, |item, unit| item.of(unit));
        item.each(&kept(scope, entry).newtype, |item, name| item.using(Space::Root, name))
    }))
}

fn structure_of(scope: &Scope<'_>, object: &Stored<'_>) -> Option<(Doc, TokenStream)> {
    let (ident, fields) = object.record()?;
    let fields = fields.zip(0_usize..).map(|((entry, name), item)| {
        let (doc, value, item) = (entry_doc(scope, entry), kept(scope, entry).field(), literal::number(item));
        quote!(#doc #item #name: #value;)
    });
    let (runtime, doc) = (scope.runtime, &object.doc);
    Some((Doc::default(), quote!(#runtime::record! { #doc pub struct #ident; #(#fields)* })))
}

/// The default values on an axis.
fn default(scope: &Scope<'_>, stored: &Stored<'_>, object: &Object) -> TokenStream {
    let mut values = stored.on(object).map(|(first, entry)| {
        let value = kept(scope, first);
        value.wrap(default::kept(entry, value.primitive))
    });
    match &stored.shape {
        Shape::Single => values.next().unwrap_or_default(),
        Shape::Array if are_alike(stored.on(object).map(|(_, entry)| entry)) => {
            let (value, count) = (values.next(), literal::number(stored.entries.len()));
            quote!([#value; #count])
        }
        Shape::Array => quote!([#(#values),*]),
        Shape::List => {
            let count = values.next();
            quote!(sdo::List { count: #count, items: [#(#values),*] })
        }
        Shape::Record(ident, fields) => quote!(#ident { #(#fields: #values),* }),
    }
}

/// Whether all have the same default.
fn are_alike<'a>(mut entries: impl Iterator<Item = &'a Entry>) -> bool {
    entries.next().is_none_or(|first| entries.all(|entry| entry.default == first.default))
}

/// A line for each object.
fn fields(scope: &Scope<'_>, objects: &[&Stored<'_>]) -> TokenStream {
    let fields = objects.iter().map(|object| {
        let Stored { doc, name, field, .. } = object;
        let (number, default) = (literal::number(object.number), default(scope, object, object.placed.first));
        let kept = match object.shape {
            Shape::Single => quote!(value),
            Shape::Array => quote!(items),
            Shape::List => quote!(list),
            Shape::Record(..) => quote!(record),
        };
        quote!(#doc #number #name: #field = #default, #kept;)
    });
    fields.collect()
}

fn device(scope: &Scope<'_>, objects: &[&Stored<'_>], of_axis: &[&Stored<'_>]) -> TokenStream {
    let (runtime, fields) = (scope.runtime, fields(scope, objects));
    let axes = (!of_axis.is_empty()).then(|| axes_default(scope, of_axis));
    let default = "The values that the manual gives as defaults, 0 where it gives none.";
    quote! {
        #runtime::dictionary! {
            /// Every object whose value can change.
            pub struct Dictionary, #default;
            #fields
            #axes
        }
    }
}

fn axis(scope: &Scope<'_>, objects: &[&Stored<'_>]) -> TokenStream {
    let (runtime, fields) = (scope.runtime, fields(scope, objects));
    quote! {
        #runtime::dictionary! {
            /// Every object of an axis whose value can change, by its index on the first axis.
            pub struct AxisDictionary, "The defaults of the first axis.";
            #fields
        }
    }
}

/// The defaults of all axes, of which only those that differ from the first axis are written out.
fn axes_default(scope: &Scope<'_>, objects: &[&Stored<'_>]) -> TokenStream {
    let count = scope.device.axes.len();
    let of_axes: Vec<Vec<TokenStream>> = (0..count).map(|axis| differing(scope, objects, axis)).collect();
    let number = literal::number(count);
    if of_axes.iter().all(Vec::is_empty) {
        return quote!(axes AxisDictionary, #number = [AxisDictionary::DEFAULT; #number];);
    }
    let axes = of_axes.iter().map(|differing| match differing.as_slice() {
        [] => quote!(AxisDictionary::DEFAULT),
        differing => quote!(AxisDictionary { #(#differing)* ..AxisDictionary::DEFAULT }),
    });
    quote!(axes AxisDictionary, #number = [#(#axes),*];)
}

/// The defaults that an axis has for itself.
fn differing(scope: &Scope<'_>, objects: &[&Stored<'_>], axis: usize) -> Vec<TokenStream> {
    let differs = |(first, entry): (&Entry, &Entry)| entry.default != first.default;
    let of_axis = objects.iter().filter_map(|stored| {
        let object = stored.placed.all.get(axis)?;
        let (name, default) = (&stored.name, || default(scope, stored, object));
        stored.on(object).any(differs).then(default).map(|default| quote!(#name: #default,))
    });
    of_axis.collect()
}
