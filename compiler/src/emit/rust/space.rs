//! The modules that every device has, and what they begin with.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::braces::braces;
use super::doc::Doc;
use super::item::Space;

impl Space {
    /// The name of the module.
    pub(super) fn name(self) -> Ident {
        format_ident!(
            "{}",
            match self {
                Self::Root => "root",
                Self::Objects => "objects",
                Self::Configurations => "configurations",
                Self::Units => "units",
                Self::Dictionary => "dictionary",
            }
        )
    }

    pub(super) fn doc(self) -> Doc {
        Doc::new(match self {
            Self::Root => "",
            Self::Objects => "The entries of the object dictionary, as a master reads and writes them.",
            Self::Configurations => {
                "Start-up lists of the choices that are described, what to write in order, and the process data that there is then."
            }
            Self::Units => "What raw values mean, and how to come from physical values to raw ones.",
            Self::Dictionary => {
                "The object dictionary as a firmware keeps it: values with their defaults, and a table of all entries."
            }
        })
    }

    /// What is imported.
    pub(super) fn imports(self, runtime: &TokenStream) -> TokenStream {
        match self {
            Self::Root => TokenStream::new(),
            Self::Objects | Self::Configurations | Self::Units => quote!(
                use super::*;
            ),
            Self::Dictionary => quote!(
                use super::*;
                use #runtime::sdo::shorthand::*;
                use #runtime::sdo::{self, DataType, EntryInfo, Page, positions};
            ),
        }
    }
    /// The module with what is in it, if there is something.
    pub(super) fn module(
        self,
        runtime: &TokenStream,
        items: impl Iterator<Item = TokenStream>,
    ) -> TokenStream {
        let mut items = items.peekable();
        if items.peek().is_none() {
            return TokenStream::new();
        }
        let (doc, name, imports) = (self.doc(), self.name(), self.imports(runtime));
        let content = braces(std::iter::once(imports).chain(items));
        quote!(#doc pub mod #name #content)
    }
}
