//! The error codes of 0x603F.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::doc::{Doc, escape, place, sentence};
use super::item::Item;
use super::literal::{hex8, hex16, line, number, option};
use super::names::{Names, shout};
use super::scope::Scope;
use super::types::address;
use crate::model::{Device, ErrorCode, Meaning};

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Option<Item<'s>> {
    let name = scope.types.newtype(address(0x603F)).filter(|_| !scope.device.errors.is_empty())?;
    let item = Item::new(name.clone(), move || code(scope, name)).of(&scope.device.errors);
    let entry = scope.device.entry(address(0x603F));
    Some(item.each(entry, |item, entry| item.of(&entry.values).of(&entry.source)))
}

fn code(scope: &Scope<'_>, name: &Ident) -> (Doc, TokenStream) {
    let (ranges, mut codes): (Vec<&ErrorCode>, Vec<&ErrorCode>) =
        scope.device.errors.iter().partition(|error| error.is_range());
    let values = values(scope.device);
    codes.extend(
        values.iter().filter(|value| scope.device.errors.iter().all(|error| error.code != value.code)),
    );
    codes.sort_by_key(|error| error.code);
    let mut names = Names::default();
    let constants = codes.iter().map(|code| constant(scope, code, &names.claim(&shout(&code.id))));
    let (table, runtime) = (table(name, &codes, &ranges), scope.runtime);
    let doc = Doc::new("`0x603F` An error code. Codes that the description does not name keep their number.");
    let doc = ranges.iter().fold(doc, |doc, range| {
        let row = format!("0x{:04X} to 0x{:04X}", range.code, range.last);
        doc.of_row(row, ERROR, &range.origin, scope.device)
    });
    let code = quote! {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct #name(pub u16);

        impl #name { #(#constants)* }

        #runtime::value!(#name as u16);

        #table

        impl core::fmt::Display for #name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                error::display(*self).fmt(f)
            }
        }
    };
    (doc, code)
}

/// The values that the object itself names, as that of no error.
fn values(device: &Device) -> Vec<ErrorCode> {
    let Some(entry) = device.entry(address(0x603F)) else { return Vec::new() };
    let codes = entry.values.iter().filter_map(|value| Some((value, u16::try_from(value.value).ok()?)));
    let error = |(value, code): (&Meaning, u16)| ErrorCode {
        code,
        last: code,
        id: value.id.clone(),
        name: value.name.clone(),
        about: value.about.clone(),
        source: entry.source.clone(),
        ..ErrorCode::default()
    };
    codes.map(error).collect()
}

/// What the constants and the table are made of.
const ERROR: &[&str] = &["name", "register", "vendor-codes", "about", "remedy"];

fn constant(scope: &Scope<'_>, error: &ErrorCode, name: &Ident) -> TokenStream {
    let vendor: Vec<String> = error.vendor_codes.iter().map(u32::to_string).collect();
    let facts = [
        error.register.map(|register| format!("Error register 0x{register:02X}.")),
        (!vendor.is_empty()).then(|| format!("Vendor code {}.", vendor.join(", "))),
        error.source.as_ref().map(|source| format!("({})", place(source, scope.device))),
    ];
    let facts: Vec<String> = facts.into_iter().flatten().collect();
    let doc = Doc::new(format!("{} {}", sentence(&error.name), escape(&facts.join(" "))))
        .maybe(error.about.as_deref())
        .maybe(error.remedy.as_deref())
        .departing(ERROR, &error.origin, scope.device);
    let code = hex16(error.code);
    quote!(#doc pub const #name: Self = Self(#code);)
}

fn table(name: &Ident, codes: &[&ErrorCode], ranges: &[&ErrorCode]) -> TokenStream {
    let codes = codes.iter().map(|error| {
        let (code, name, text) = (hex16(error.code), &error.name, text(error));
        let register = option(error.register.map(hex8));
        let vendor = error.vendor_codes.iter().copied().map(number);
        quote!(info(#code, #name, #register, &[#(#vendor),*], #text))
    });
    let ranges = ranges.iter().map(|range| {
        let (first, last, name) = (hex16(range.code), hex16(range.last), &range.name);
        quote!(ErrorRange { first: #first, last: #last, name: #name })
    });
    quote! {
        impl error::ErrorCode for #name {
            const TABLE: &'static [ErrorInfo] = {
                const fn info(
                    code: u16,
                    name: &'static str,
                    register: Option<u8>,
                    vendor_codes: &'static [u32],
                    text: &'static str,
                ) -> ErrorInfo {
                    ErrorInfo { code, name, register, vendor_codes, text }
                }
                &[#(#codes),*]
            };
            const RANGES: &'static [ErrorRange] = &[#(#ranges),*];
            fn code(self) -> u16 {
                self.0
            }
        }
    }
}

/// Meaning and remedy.
fn text(error: &ErrorCode) -> String {
    let parts = [error.about.as_deref(), error.remedy.as_deref()];
    line(&parts.into_iter().flatten().collect::<Vec<_>>().join(" "))
}
