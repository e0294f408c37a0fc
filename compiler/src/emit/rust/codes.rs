//! Numbers of which some have names. The others stay what they are.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::doc::{Doc, escape, sentence};
use super::item::Item;
use super::literal::{hex16, line, number, parsed};
use super::names::{Names, shout};
use super::scope::Scope;
use super::types::{Code, Primitive};
use crate::model::{AlStatusCode, Device, VendorCode};

/// A struct around a number.
struct Newtype<'a> {
    doc: Doc,
    name: Ident,
    primitive: Primitive,
    /// How the number is shown, as `core::fmt` has it.
    shown: &'a str,
    values: Vec<Named<'a>>,
    /// Methods of its own.
    methods: TokenStream,
}

/// A value with a name.
struct Named<'a> {
    literal: Literal,
    id: &'a str,
    name: &'a str,
    /// What there is to say of it.
    text: Option<String>,
    doc: Doc,
}

/// The values of entries, the vendor's own codes, and the AL status codes.
pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let Device { vendor, vendor_codes, al_status_codes, .. } = scope.device;
    let of_entries = scope.types.codes.iter().map(|code| {
        let item = Item::new(code.name.clone(), || of_entry(code, scope.device).tokens(scope.runtime));
        let title = super::entry::title(code.entry);
        item.of(&code.entry.values).of(&code.entry.about).told(format!("{title}{:?}", code.primitive))
    });
    let of_vendor = (!vendor_codes.is_empty()).then(|| {
        let item = Item::new(vendor_name(), || self::vendor_codes(scope).tokens(scope.runtime));
        item.of(vendor_codes).of(vendor)
    });
    let of_state = (!al_status_codes.is_empty()).then(|| {
        let item = Item::new(al_status_name(), || self::al_status_codes(scope).tokens(scope.runtime));
        item.of(al_status_codes)
    });
    of_entries.chain(of_vendor).chain(of_state).collect()
}

fn vendor_name() -> Ident {
    format_ident!("VendorCode")
}

fn al_status_name() -> Ident {
    format_ident!("AlStatusCode")
}

fn of_entry<'a>(code: &Code<'a>, device: &Device) -> Newtype<'a> {
    let values = code.entry.values.iter().map(|meaning| Named {
        literal: number(meaning.value),
        id: &meaning.id,
        name: &meaning.name,
        text: meaning.about.clone(),
        doc: Doc::new(sentence(&meaning.name)).maybe(meaning.about.as_deref()),
    });
    let doc = Doc::new(super::entry::title(code.entry)).maybe(code.entry.about.as_deref());
    let enumeration = device.enumeration_of(code.entry).into_iter();
    let doc = enumeration.fold(doc, |doc, named| doc.departing(&["values"], &named.origin, device));
    Newtype {
        doc,
        name: code.name.clone(),
        primitive: code.primitive,
        shown: "{}",
        values: values.collect(),
        methods: TokenStream::new(),
    }
}

fn vendor_codes<'a>(scope: &Scope<'a>) -> Newtype<'a> {
    let codes = &scope.device.vendor_codes;
    let values = codes.iter().map(|code| Named {
        literal: number(code.code),
        id: &code.name,
        name: &code.name,
        text: code.about.clone(),
        doc: Doc::new(sentence(&code.name)).maybe(code.about.as_deref()).said(
            code.source.as_ref(),
            &code.origin,
            scope.device,
        ),
    });
    Newtype {
        doc: Doc::new(format!("An error code of {}'s own system.", escape(&scope.device.vendor))),
        name: vendor_name(),
        primitive: Primitive::Unsigned(32),
        shown: "{}",
        values: values.collect(),
        methods: causes(codes),
    }
}

/// What can have caused an error, by the number that the device gives the cause.
fn causes(codes: &[VendorCode]) -> TokenStream {
    let causes = codes.iter().flat_map(|code| code.causes.iter().map(move |cause| (code, cause)));
    let arms: Vec<TokenStream> = causes
        .map(|(code, cause)| {
            let (code, number, name) = (number(code.code), number(cause.value), &cause.name);
            quote!((#code, #number) => Some(#name),)
        })
        .collect();
    if arms.is_empty() {
        return TokenStream::new();
    }
    let some = parsed("Option<&'static str>");
    quote! {
        /// The cause that goes by that number, if the description has it.
        pub const fn cause(self, number: i64) -> #some {
            match (self.0, number) {
                #(#arms)*
                _ => None,
            }
        }
    }
}

fn al_status_codes<'a>(scope: &Scope<'a>) -> Newtype<'a> {
    let values = scope.device.al_status_codes.iter().map(|code| {
        let AlStatusCode { code: number, name, during, results, about, source, origin } = code;
        let during = (!during.is_empty()).then(|| format!("In the transitions {}.", during.join(", ")));
        let results = results.as_ref().map(|results| format!("Results in {results}."));
        let parts = [about.clone(), during, results];
        let text = parts.iter().flatten().map(|part| part.trim()).collect::<Vec<_>>().join(" ");
        Named {
            literal: hex16(*number),
            id: name,
            name,
            doc: Doc::new(sentence(name)).text(&escape(&text)).said(source.as_ref(), origin, scope.device),
            text: Some(text),
        }
    });
    Newtype {
        doc: Doc::new(
            "Why the device refused or left an EtherCAT state: the AL status code, register 0x0134.",
        ),
        name: al_status_name(),
        primitive: Primitive::Unsigned(16),
        shown: "0x{:04X}",
        values: values.collect(),
        methods: TokenStream::new(),
    }
}

impl Newtype<'_> {
    fn tokens(&self, runtime: &TokenStream) -> (Doc, TokenStream) {
        let Self { doc, name, primitive, shown, values, methods } = self;
        let (number, some) = (primitive.tokens(), parsed("Option<&'static str>"));
        let mut names = Names::default();
        let constants = values.iter().map(|Named { literal, id, doc, .. }| {
            let constant = names.claim(&shout(id));
            let value = primitive.constant(quote!(#literal));
            quote!(#doc pub const #constant: Self = Self(#value);)
        });
        let arms = values.iter().map(|Named { literal, name, .. }| quote!(#literal => Some(#name),));
        let (texts, counted) = (self.texts(), primitive.counted(quote!(self.0)));
        let code = quote! {
            #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
            pub struct #name(pub #number);

            impl #name {
                #(#constants)*

                /// What the value stands for, if the description says so.
                pub const fn name(self) -> #some {
                    match #counted {
                        #(#arms)*
                        _ => None,
                    }
                }

                #texts
                #methods
            }

            #runtime::named!(#name, #shown);
            #runtime::value!(#name as #number);
        };
        (doc.clone(), code)
    }

    /// What the description says of the values, if it says something of any.
    fn texts(&self) -> Option<TokenStream> {
        let told = self.values.iter().filter_map(|value| Some((value, line(value.text.as_deref()?))));
        let arms: Vec<TokenStream> = told
            .filter(|(_, text)| !text.is_empty())
            .map(|(value, text)| {
                let literal = &value.literal;
                quote!(#literal => #text,)
            })
            .collect();
        let (text, counted) = (parsed("&'static str"), self.primitive.counted(quote!(self.0)));
        (!arms.is_empty()).then(|| {
            quote! {
                /// What the description says of the value; empty if nothing.
                pub const fn text(self) -> #text {
                    match #counted {
                        #(#arms)*
                        _ => "",
                    }
                }
            }
        })
    }
}
