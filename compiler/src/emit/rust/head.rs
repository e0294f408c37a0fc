//! What a module begins with: what it is of, the device, the axes.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::axes::shift;
use super::doc::{Doc, escape, sentence};
use super::item::Item;
use super::literal::{hex32, number};
use super::measured;
use super::scope::Scope;
use super::types::Primitive;
use crate::model::{Device, Index};

/// What the code of a module needs of the runtime.
pub(super) fn imports(scopes: &[Scope<'_>]) -> TokenStream {
    let Some(runtime) = scopes.first().map(|scope| scope.runtime) else { return TokenStream::new() };
    let widths = scopes.iter().flat_map(Scope::widths).collect::<BTreeSet<_>>();
    let widths: Vec<TokenStream> = widths.into_iter().map(Primitive::tokens).collect();
    let units: BTreeSet<Ident> = scopes.iter().flat_map(|scope| measured::types(&scope.units)).collect();
    let widths = import(runtime, &format_ident!("object"), &widths);
    let units = import(runtime, &format_ident!("unit"), &Vec::from_iter(units));
    quote! {
        use #runtime::cia402::{
            Command, Condition, Coupling, Edge, Events, HomingBits, Machine, Mode, ModeChange,
            Modes, Pattern, Refusal, State, StatePatterns, StateSet, Transition, UnknownState,
        };
        use #runtime::error::{ErrorInfo, ErrorRange};
        #widths
        use #runtime::object::{Address, BitField, Constant, Entry, ReadOnly, ReadWrite, WriteOnly};
        use #runtime::pdo::{
            Carrier, MappedPdo, Mapping, MappingObject, Members, Pdo, ProcessData, ProcessImage, Rx, RxTx, SyncManager, Tx,
            Unmapped,
        };
        use #runtime::start_up::{AxisObjects, BringUp, CycleLimit, Write};
        #units
        use #runtime::{Device, error};
    }
}

/// What nobody is to be warned of.
pub(super) fn allowed() -> TokenStream {
    quote! {
        #![allow(
            dead_code, unused_imports, unreachable_pub, clippy::identity_op, clippy::unnecessary_cast,
            reason = "what of it is used is up to the device and to those who include the module"
        )]
    }
}

/// Names out of a module of the runtime, if there are any.
fn import(runtime: &TokenStream, module: &Ident, names: &[impl ToTokens]) -> TokenStream {
    match names {
        [] => TokenStream::new(),
        [only] => quote!(use #runtime::#module::#only;),
        names => quote!(use #runtime::#module::{#(#names),*};),
    }
}

/// The axes, if something is there for each.
pub(super) fn axes_item<'s>(scope: &'s Scope<'_>) -> Option<Item<'s>> {
    let Device { axes, arrangement, .. } = scope.device;
    let item = || Item::new(format_ident!("Axis"), || self::axes(scope)).of(axes).of(arrangement);
    scope.has_axes.then(item)
}

pub(super) fn module_doc(device: &Device) -> Doc {
    let title = device.title.as_deref().map(|title| format!(": {title}")).unwrap_or_default();
    let documents = device.documents.iter().map(|document| {
        let parts = [
            document.publisher.as_ref(),
            Some(&document.title),
            document.number.as_ref(),
            document.edition.as_ref(),
        ];
        let parts: Vec<&str> = parts.into_iter().flatten().map(String::as_str).collect();
        format!("- {}", escape(&parts.join(", ")))
    });
    let doc = Doc::new(format!("{} {}{}.", escape(&device.vendor), escape(&device.name), escape(&title)))
        .maybe(device.about.as_deref())
        .maybe(device.arrangement.coupling.as_deref());
    let first = device.documents.first().map(|document| document.number.as_ref().unwrap_or(&document.title));
    match first {
        Some(first) => doc
            .text(&format!(
                "A source without a document is a place in the first of these, {}:",
                escape(first)
            ))
            .lines(documents),
        None => doc,
    }
}

/// The type that stands for the device.
pub(super) fn device(scope: &Scope<'_>) -> TokenStream {
    let marker = &scope.marker;
    if scope.marker_is_outside {
        return quote!(use super::#marker;);
    }
    let doc = Doc::new(format!("The {}.", escape(&scope.device.name)))
        .maybe(
            (!scope.device.models.is_empty())
                .then(|| format!("Models: {}.", scope.device.models.join(", ")))
                .as_deref(),
        )
        .said(scope.device.identity.source.as_ref(), &scope.device.identity.origin, scope.device)
        .departing(&["name", "vendor", "title", "about", "models"], &scope.device.origin, scope.device);
    let identity = identity(scope.device, marker, &quote!(Device));
    quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct #marker;

        #identity
    }
}

/// The identity of the device, for the type that stands for it.
pub(crate) fn identity(device: &Device, marker: &proc_macro2::Ident, as_device: &TokenStream) -> TokenStream {
    let name = &device.name;
    let identity = &device.identity;
    let (vendor_id, product_code, revision) =
        (hex32(identity.vendor_id), hex32(identity.product_code), hex32(identity.revision));
    quote! {
        impl #as_device for #marker {
            const NAME: &'static str = #name;
            const VENDOR_ID: u32 = #vendor_id;
            const PRODUCT_CODE: u32 = #product_code;
            const REVISION: u32 = #revision;
        }
    }
}

fn axes(scope: &Scope<'_>) -> (Doc, TokenStream) {
    let axes = &scope.device.axes;
    let variants = axes.iter().zip(scope.axis_idents()).map(|(axis, (variant, _))| {
        let name = format!("Axis {}", axis.name);
        let doc = Doc::new(
            axis.about
                .as_deref()
                .map_or_else(|| sentence(&name), |about| sentence(&format!("{name}: {about}"))),
        );
        let number = number(axis.number);
        quote!(#doc #variant = #number,)
    });
    let all = scope.axis_idents().into_iter().map(|(variant, _)| quote!(Self::#variant));
    let count = number(axes.len());
    let distance = shift(scope.device, Index(0x6000))
        .map(|by| format!("Objects of the drive profile are 0x{by:X} apart."));
    let doc = Doc::new("The axes of the device.").text(&distance.unwrap_or_default());
    let doc = doc.departing(&["names", "about", "shifts"], &scope.device.arrangement.origin, scope.device);
    let (owner, within) = (&scope.owner, &scope.within.1);
    let code = quote! {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum Axis { #(#variants)* }

        impl Axis {
            /// Every axis, in order.
            pub const ALL: [Self; #count] = [#(#all),*];

            /// The index that is `first` on the first axis and `shift` higher on each that follows.
            #within const fn index(self, first: u16, shift: u16) -> u16 {
                first.wrapping_add(shift.wrapping_mul(self as u16))
            }

            #within const fn entry<T: ?Sized, A, M>(
                self,
                first: u16,
                shift: u16,
                subindex: u8,
            ) -> Entry<#owner, T, A, M> {
                Entry::new(self.index(first, shift), subindex)
            }
        }
    };
    (doc, code)
}
