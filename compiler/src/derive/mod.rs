//! What the derives do. `#[derive(Device)]` is a front end like the command line, over the same stages.
//!
//! It lives here and not in the macro crate so that it can be tested as any other code: nothing in it depends on
//! running inside the compiler.

mod beneath;
mod choice;
mod errors;
mod expression;
mod input;
mod own_pdo;
mod process_image;
mod record;
mod settings;

use std::path::Path;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Error;
use syn::ext::IdentExt;

use crate::diagnostic::render::{Style, text};
use crate::diagnostic::{Diagnostic, Level};
use crate::emit::rust::{LINTS, Options, identity, member};
use crate::lint::Levels;
use crate::model::{Device, Family};
use crate::source::Loader;
use crate::{Compilation, Request, compile_with};
use beneath::Beneath;
use input::Input;
pub use own_pdo::own_pdo;
pub use process_image::process_image;

/// Expands `#[derive(Device)] #[device(path = "..")] pub struct Name;`.
///
/// `path` is taken from `root`, the folder of the user's manifest. The result is the implementation of `Device` and a
/// module with all that the command line writes to a file; if there are errors, it is a `compile_error!` for each, and
/// as much of the rest as keeps further errors away. Whatever was read is named in it, so that a change rebuilds.
pub fn expand(input: TokenStream, root: &Path, loader: &dyn Loader) -> TokenStream {
    match Input::parse(input) {
        Ok(input) => expand_input(&input, root, loader),
        Err(error) => error.into_compile_error(),
    }
}

fn expand_input(input: &Input, root: &Path, loader: &dyn Loader) -> TokenStream {
    let request = Request { levels: Levels::default(), outputs: LINTS.to_vec() };
    let compilation = compile_with(&Beneath { root, loader }, Path::new(&input.path), &request, &mut |_| ());
    let files = tracked(root, &compilation);
    let content = match &compilation.family {
        Some(family) => choose(input, family).map(|device| module(input, device)),
        None => Err(errors(input, &compilation)),
    };
    let content = content.unwrap_or_else(|errors| {
        let stub = stub(input);
        quote!(#errors #stub)
    });
    quote!(#content #files)
}

/// The member that is asked for; without being asked for, the only one.
fn choose<'f>(input: &Input, family: &'f Family) -> Result<&'f Device, TokenStream> {
    let found = match (&input.member, family.members.as_slice()) {
        (None, [only]) => Some(only),
        (None, _) => None,
        (Some(id), members) => members.iter().find(|member| member.id == *id),
    };
    found.ok_or_else(|| {
        let ids: Vec<String> = family.members.iter().map(|member| format!("`{}`", member.id)).collect();
        let message = match &input.member {
            Some(id) => format!("`{}` has no member `{id}`, but {}", family.id, ids.join(", ")),
            None => format!("`{}` is a family: add `member = \"..\"`, one of {}", family.id, ids.join(", ")),
        };
        Error::new(input.span, message).into_compile_error()
    })
}

fn module(input: &Input, device: &Device) -> TokenStream {
    let (name, module, runtime) = (&input.name, &input.module, &input.runtime);
    let options =
        Options { runtime: runtime.clone(), device: Some(name.clone()), dictionary: input.dictionary };
    let (identity, content) = (identity(device, name, &quote!(#runtime::Device)), member(device, &options));
    quote! {
        #identity

        pub mod #module { #content }
    }
}

/// An error for each message, with the place in the description in its text.
fn errors(input: &Input, compilation: &Compilation) -> TokenStream {
    let errors = compilation.diagnostics.iter().filter(|diagnostic| diagnostic.level == Level::Error);
    let shown = errors.map(|error| Error::new(input.span, message(error, compilation)));
    shown.map(Error::into_compile_error).collect()
}

/// The message as on the command line, but for the word `error`, which rustc puts before it.
fn message(error: &Diagnostic, compilation: &Compilation) -> String {
    let text = text(error, &compilation.sources, Style::Plain);
    text.strip_prefix("error").map(str::to_owned).unwrap_or(text)
}

/// What the rest of the user's code needs of a device that could not be read.
fn stub(input: &Input) -> TokenStream {
    let (name, module, runtime) = (&input.name, &input.module, &input.runtime);
    quote! {
        impl #runtime::Device for #name {
            const NAME: &'static str = "";
            const VENDOR_ID: u32 = 0;
            const PRODUCT_CODE: u32 = 0;
            const REVISION: u32 = 0;
        }

        /// Empty because of the errors in the description.
        pub mod #module {}
    }
}

/// The files that were read: rustc notes those that code includes.
fn tracked(root: &Path, compilation: &Compilation) -> TokenStream {
    let files = compilation.files.iter().map(|file| root.join(file).to_string_lossy().into_owned());
    quote!(#(const _: &[u8] = ::core::include_bytes!(#files);)*)
}

/// A path of ours as if it stood in the user's code: so that is where an error is shown.
fn located(path: &TokenStream, span: Span) -> TokenStream {
    let located = path.clone().into_iter().map(|mut token| {
        token.set_span(token.span().located_at(span));
        token
    });
    located.collect()
}

/// `C887` is `c887`, `HexapodController` is `hexapod_controller`.
fn module_name(name: &Ident) -> Ident {
    let mut id = String::new();
    let mut before = '-';
    for c in name.unraw().to_string().chars() {
        if c.is_uppercase() && (before.is_lowercase() || before.is_ascii_digit()) {
            id.push('-');
        }
        id.push(c);
        before = c;
    }
    crate::emit::rust::snake(&id)
}

#[cfg(test)]
mod tests;
