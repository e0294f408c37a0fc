//! The modes of operation.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::doc::{Doc, escape, sentence};
use super::item::Item;
use super::literal::{line, number, parsed};
use super::names::{Names, camel};
use super::scope::Scope;
use crate::model::Mode;

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Option<Item<'s>> {
    // the object of the mode holds 8 bits
    let modes: Vec<(&Mode, i8)> =
        scope.device.modes.iter().filter_map(|mode| Some((mode, i8::try_from(mode.code).ok()?))).collect();
    let item =
        |modes: Vec<(&'s Mode, i8)>| Item::new(format_ident!("ModeOfOperation"), move || code(scope, &modes));
    (!modes.is_empty()).then(|| item(modes).of(&scope.device.modes))
}

fn code(scope: &Scope<'_>, modes: &[(&Mode, i8)]) -> (Doc, TokenStream) {
    let mut names = Names::default();
    let names: Vec<Ident> = modes.iter().map(|(mode, _)| names.claim(&camel(&mode.id))).collect();
    let variants = modes.iter().zip(&names).map(|((mode, code), name)| {
        let (doc, code) = (doc(scope, mode), number(*code));
        quote!(#doc #name = #code,)
    });
    let (texts, implementation) = (texts(modes, &names), implementation(modes, &names));
    let code = quote! {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[repr(i8)]
        pub enum ModeOfOperation { #(#variants)* }

        #texts
        #implementation

        impl core::fmt::Display for ModeOfOperation {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.write_str(self.name())
            }
        }
    };
    (Doc::new("`0x6060` The modes of operation."), code)
}

fn doc(scope: &Scope<'_>, mode: &Mode) -> Doc {
    let doc = Doc::new(sentence(&mode.name)).maybe(mode.about.as_deref());
    let doc = mode.conditions.iter().fold(doc, |doc, condition| doc.text(&escape(condition)));
    let doc = if mode.cautions.is_empty() {
        doc
    } else {
        doc.text("Caution:").lines(mode.cautions.iter().map(|caution| format!("- {}", escape(caution))))
    };
    doc.said(mode.source.as_ref(), &mode.origin, scope.device)
}

/// What the drive does in the modes.
fn texts(modes: &[(&Mode, i8)], names: &[Ident]) -> TokenStream {
    let arms = modes.iter().zip(names).map(|((mode, _), name)| {
        let text = line(mode.about.as_deref().unwrap_or_default());
        quote!(Self::#name => #text,)
    });
    let text = parsed("&'static str");
    quote! {
        impl ModeOfOperation {
            /// What the drive does in the mode; empty if the description does not say.
            pub const fn text(self) -> #text {
                match self {
                    #(#arms)*
                }
            }
        }
    }
}

fn implementation(modes: &[(&Mode, i8)], names: &[Ident]) -> TokenStream {
    let from_code = modes.iter().zip(names).map(|((mode, code), name)| {
        let aliases = mode.aliases.iter().filter_map(|alias| i8::try_from(*alias).ok());
        let codes = std::iter::once(*code).chain(aliases).map(number);
        quote!(#(#codes)|* => Some(Self::#name),)
    });
    let texts = modes.iter().zip(names).map(|((mode, _), name)| {
        let text = &mode.name;
        quote!(Self::#name => #text,)
    });
    quote! {
        impl Mode for ModeOfOperation {
            fn code(self) -> i8 {
                self as i8
            }

            fn from_code(code: i8) -> Option<Self> {
                match code {
                    #(#from_code)*
                    _ => None,
                }
            }

            fn name(self) -> &'static str {
                match self {
                    #(#texts)*
                }
            }
        }
    }
}
