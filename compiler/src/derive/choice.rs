//! What the attribute of a mapping says for all of its fields.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use syn::ext::IdentExt;
use syn::parse::Parse;
use syn::{Error, Expr, Path, Result};

use super::errors::both;
use super::expression::bare;
use super::located;
use super::record::Record;
use super::settings::{Settings, Vocabulary};

const PDO: Vocabulary =
    Vocabulary { attribute: "pdo", keys: &["mapping", "per_axis", "gap", "runtime"], takes_entry: false };

/// What the attribute of the struct says.
pub(super) struct Choice {
    /// The path of the runtime crate.
    pub(super) runtime: TokenStream,
    /// The type of the free PDO.
    pub(super) free: Path,
    /// The type of the axes, if each has the PDO.
    pub(super) axis: Option<TokenStream>,
    /// Bits behind the last field.
    pub(super) gap: Option<u8>,
}

impl Choice {
    pub(super) fn of(record: &Record) -> Result<Self> {
        let settings = Settings::parse(&record.attributes, &PDO)?;
        let missing = "which PDO is mapped? Add `#[pdo(mapping = s700::FreeRxPdo1600)]`";
        let free = settings
            .name("mapping", Path::parse, "path of a free PDO")
            .and_then(|free| free.ok_or_else(|| Error::new(record.name.span(), missing)));
        let others = both(settings.flag("per_axis"), settings.number("gap", "bits"));
        let ((runtime, free), (per_axis, gap)) = both(both(settings.runtime(), free), others)?;
        let module = parent(&free);
        Ok(Self { runtime, free, axis: per_axis.then(|| quote!(#module Axis)), gap })
    }

    /// The entry of a field, an expression: what its attribute names, or what has its name beside the free PDO.
    pub(super) fn entry(&self, field: &Ident, named: Option<Expr>) -> TokenStream {
        let (module, per_axis) = (located(&parent(&self.free), field.span()), self.axis.is_some());
        match named {
            Some(entry) if per_axis && is_function(&entry) => quote!(#entry(axis)),
            Some(entry) => entry.into_token_stream(),
            None if per_axis => quote!(#module objects::#field(axis)),
            None => {
                let constant = Ident::new(&field.unraw().to_string().to_ascii_uppercase(), field.span());
                quote!(#module objects::#constant)
            }
        }
    }
}

/// The path of what a type is in, with the colons behind it; nothing if it is named alone.
fn parent(path: &Path) -> TokenStream {
    let (root, parents) = (&path.leading_colon, path.segments.len().saturating_sub(1));
    let parents = path.segments.pairs().take(parents);
    quote!(#root #(#parents)*)
}

/// Whether an expression names a function: constants are in capitals.
fn is_function(entry: &Expr) -> bool {
    let Expr::Path(entry) = bare(entry) else { return false };
    let name = entry.path.segments.last();
    name.is_some_and(|name| name.ident.unraw().to_string().chars().any(char::is_lowercase))
}
