//! The way from a place that the table names to the value in its field.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::literal::{hex16, number, option};
use super::ranges;
use super::scope::Scope;
use super::stored::{Shape, Stored, kept};
use super::types::{Primitive, ValueType};
use crate::model::{Direction, Role};

pub(super) fn items(scope: &Scope<'_>, stored: &[Stored<'_>]) -> TokenStream {
    let (of_axis, of_device): (Vec<&Stored<'_>>, Vec<&Stored<'_>>) =
        stored.iter().partition(|object| object.is_of_axis());
    let otherwise = match of_axis.is_empty() {
        true => quote!(None),
        false => quote!(self.axes.get_mut(usize::from(place.axis))?.slot(place)),
    };
    let device = body(scope, &of_device, &otherwise);
    let axis = (!of_axis.is_empty()).then(|| axis(scope, &of_axis));
    let records = stored.iter().filter_map(|object| record(scope, object));
    let (constant, ranges) = ranges::items(scope, stored);
    let has_complete_access = scope.device.mailbox.as_ref().is_some_and(|mailbox| mailbox.complete_access);
    let complete_access = has_complete_access.then(|| {
        quote!(
            #[inline]
            fn has_complete_access(&self) -> bool {
                true
            }
        )
    });
    let process_data = process_data(scope);
    quote! {
        impl sdo::Values for Dictionary {
            #[inline]
            fn table(&self) -> &'static sdo::Dictionary {
                &TABLE
            }

            #constant
            #complete_access
            #process_data

            fn slot(&mut self, place: sdo::Place) -> Option<sdo::Slot<'_>> { #device }
        }
        #axis
        #(#records)*
        #ranges
    }
}

/// What process data may be made of, for a device that has any.
fn process_data(scope: &Scope<'_>) -> Option<TokenStream> {
    let (device, marker) = (scope.device, &scope.marker);
    let manager = |way| {
        device.sync_manager(Role::of(way)).map(|_| {
            let direction = super::pdos::direction(way);
            quote!(<#marker as Carries<#direction>>::SYNC_MANAGER)
        })
    };
    let (outputs, inputs) = (option(manager(Direction::Rx)), option(manager(Direction::Tx)));
    let limits = device.pdos.iter().filter_map(|pdo| Some((hex16(pdo.index.0), number(pdo.max_bytes?))));
    let limits = limits.map(|(index, bytes)| quote!((#index, #bytes)));
    (!device.pdos.is_empty()).then(|| {
        quote! {
            #[inline]
            fn process_data(&self) -> Option<&'static sdo::PdoRules> {
                Some(&const {
                    sdo::PdoRules { outputs: #outputs, inputs: #inputs, max_bytes: &[#(#limits),*] }
                })
            }
        }
    })
}

fn axis(scope: &Scope<'_>, objects: &[&Stored<'_>]) -> TokenStream {
    let body = body(scope, objects, &quote!(None));
    quote! {
        impl AxisDictionary {
            fn slot(&mut self, place: sdo::Place) -> Option<sdo::Slot<'_>> { #body }
        }
    }
}

/// Finds the value by the number of its field.
fn body(scope: &Scope<'_>, objects: &[&Stored<'_>], otherwise: &TokenStream) -> TokenStream {
    let arms = objects.iter().map(|object| {
        let (field, value) = (number(object.number), field(scope, object));
        quote!(#field => #value,)
    });
    let has_arrays = objects.iter().any(|object| matches!(object.shape, Shape::Array));
    let item = has_arrays.then(|| quote!(let item = usize::from(place.item);));
    quote! {
        #item
        match place.field { #(#arms)* _ => #otherwise, }
    }
}

fn field(scope: &Scope<'_>, object: &Stored<'_>) -> TokenStream {
    let name = &object.name;
    match (&object.shape, object.entries.as_slice()) {
        (Shape::Single, [entry, ..]) => slot(&kept(scope, entry), &quote!(self.#name)),
        (Shape::Array, [entry, ..]) => items_of(&kept(scope, entry), &quote!(self.#name.get_mut(item))),
        (Shape::List, [_, entry, ..]) => {
            let items = items_of(&kept(scope, entry), &quote!(self.#name.item(item)));
            quote!(match place.item { 0 => Some(sdo::Slot::U8(&mut self.#name.count)), item => #items })
        }
        _ => quote!(self.#name.slot(place.item)),
    }
}

/// The fields of a record by their order.
fn record(scope: &Scope<'_>, object: &Stored<'_>) -> Option<TokenStream> {
    let (ident, fields) = object.record()?;
    let arms = fields.zip(0_usize..).map(|((entry, name), item)| {
        let (item, slot) = (number(item), slot(&kept(scope, entry), &quote!(self.#name)));
        quote!(#item => #slot,)
    });
    Some(quote! {
        impl #ident {
            fn slot(&mut self, item: u8) -> Option<sdo::Slot<'_>> {
                match item { #(#arms)* _ => None, }
            }
        }
    })
}

/// The slot of the value in a field.
fn slot(kept: &ValueType, field: &TokenStream) -> TokenStream {
    let variant = variant(kept.primitive);
    match kept.primitive {
        Primitive::Text => quote!(Some(sdo::Slot::#variant(#field))),
        primitive => {
            let place = place(primitive, kept.unwrap(field.clone()));
            quote!(Some(sdo::Slot::#variant(#place)))
        }
    }
}

/// The slot of an item of an array, if it is there.
fn items_of(kept: &ValueType, item: &TokenStream) -> TokenStream {
    let variant = variant(kept.primitive);
    match (kept.primitive, &kept.newtype) {
        (Primitive::Text, _) => quote!(#item.map(|item| sdo::Slot::#variant(*item))),
        (Primitive::Bytes(_), _) => quote!(#item.map(|item| sdo::Slot::#variant(item))),
        (_, None) if kept.primitive.is_native() => quote!(#item.map(sdo::Slot::#variant)),
        (primitive, _) => {
            let place = place(primitive, kept.unwrap(quote!(item)));
            quote!(#item.map(|item| sdo::Slot::#variant(#place)))
        }
    }
}

/// Where a value is written: its bytes, if Rust has no type for it.
fn place(primitive: Primitive, value: TokenStream) -> TokenStream {
    if primitive.is_native() { quote!(&mut #value) } else { quote!(#value.as_bytes_mut()) }
}

fn variant(primitive: Primitive) -> Ident {
    match primitive {
        _ if !primitive.is_native() => format_ident!("Bytes"),
        Primitive::Bool => format_ident!("Bool"),
        Primitive::Signed(bits) => format_ident!("I{bits}"),
        Primitive::Unsigned(bits) => format_ident!("U{bits}"),
        Primitive::Real(bits) => format_ident!("F{bits}"),
        Primitive::Bytes(_) => format_ident!("Bytes"),
        Primitive::Text => format_ident!("Text"),
    }
}
