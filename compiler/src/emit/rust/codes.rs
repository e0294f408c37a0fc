//! Numbers of which some have names. The others stay what they are.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::doc::{Doc, escape, sentence};
use super::literal::{number, parsed};
use super::names::{Names, shout};
use super::scope::Scope;
use super::types::Primitive;

/// A value with a name.
struct Named<'a> {
    literal: TokenStream,
    id: &'a str,
    name: &'a str,
    about: Option<&'a str>,
}

/// The values of entries, and the vendor's own codes.
pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    let of_entries = scope.types.codes.iter().map(|code| {
        let values = code.entry.values.iter().map(|meaning| Named {
            literal: number(meaning.value),
            id: &meaning.id,
            name: &meaning.name,
            about: meaning.about.as_deref(),
        });
        let doc = Doc::new(super::entry::title(code.entry)).maybe(code.entry.about.as_deref());
        newtype(scope, &doc, &code.name, code.primitive, &values.collect::<Vec<_>>())
    });
    let of_entries: TokenStream = of_entries.collect();
    let of_vendor = (!scope.device.vendor_codes.is_empty()).then(|| vendor_codes(scope));
    quote!(#of_entries #of_vendor)
}

fn vendor_codes(scope: &Scope<'_>) -> TokenStream {
    let values = scope.device.vendor_codes.iter().map(|code| Named {
        literal: number(code.code),
        id: &code.name,
        name: &code.name,
        about: code.about.as_deref(),
    });
    let doc = Doc::new(format!("An error code of {}'s own system.", escape(&scope.device.vendor)));
    let name = format_ident!("VendorCode");
    newtype(scope, &doc, &name, Primitive::Unsigned(32), &values.collect::<Vec<_>>())
}

fn newtype(
    scope: &Scope<'_>,
    doc: &Doc,
    name: &Ident,
    primitive: Primitive,
    values: &[Named<'_>],
) -> TokenStream {
    let (runtime, number) = (scope.runtime, primitive.tokens());
    let mut names = Names::default();
    let constants = values.iter().map(|value| {
        let (constant, literal) = (names.claim(&shout(value.id)), &value.literal);
        let doc = Doc::new(sentence(value.name)).maybe(value.about);
        quote!(#doc pub const #constant: Self = Self(#literal);)
    });
    let arms = values.iter().map(|value| {
        let (literal, name) = (&value.literal, value.name);
        quote!(#literal => Some(#name),)
    });
    let some = parsed("Option<&'static str>");
    quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub struct #name(pub #number);

        impl #name {
            #(#constants)*

            /// What the value stands for, if the description says so.
            pub const fn name(self) -> #some {
                match self.0 {
                    #(#arms)*
                    _ => None,
                }
            }
        }

        #runtime::value!(#name as #number);
    }
}
