//! Reading what the user wrote: a unit struct with a `device` attribute.

use proc_macro2::{Ident, Span, TokenStream, TokenTree};

use super::item::{Form, Item};
use super::settings::{Settings, is_identifier};
use super::{Fault, module_name};

const FORM: Form = Form {
    attribute: "device",
    expected: "a device is a unit struct, such as `pub struct C887;`: the description is all there is to it",
};

/// The struct and what its attribute says.
#[derive(Debug)]
pub(super) struct Input {
    /// The struct.
    pub(super) name: Ident,
    /// The description, from the folder of the manifest.
    pub(super) path: String,
    /// Where the path is written.
    pub(super) span: Span,
    /// The path of the runtime crate.
    pub(super) runtime: TokenStream,
    /// The name of the generated module.
    pub(super) module: Ident,
    /// The member of a family.
    pub(super) member: Option<String>,
}

impl Input {
    pub(super) fn parse(tokens: TokenStream) -> Result<Self, Fault> {
        let Item { attributes, visibility, name, body } = Item::parse(tokens, &FORM)?;
        let settings = Settings::parse(&attributes, &["path", "runtime", "module", "member"])?;
        if !matches!(body, TokenTree::Punct(_)) {
            return Err(Fault::new(name.span(), FORM.expected));
        }
        if visibility.to_string() != "pub" {
            let why = "the types of its process data are public and name it";
            return Err(Fault::new(name.span(), format!("`{name}` has to be `pub struct {name};`: {why}")));
        }
        let (path, span) = settings.text("path")?.ok_or_else(|| {
            let add = "Add `#[device(path = \"devices/c887\")]`, a path from the folder of Cargo.toml";
            Fault::new(name.span(), format!("which device is `{name}`? {add}"))
        })?;
        let module = match settings.text("module")? {
            None => module_name(&name),
            Some((module, span)) if is_identifier(&module) => Ident::new(&module, span),
            Some((module, span)) => {
                return Err(Fault::new(span, format!("`{module}` is no name of a module")));
            }
        };
        let (runtime, member) = (settings.runtime()?, settings.text("member")?.map(|(id, _)| id));
        Ok(Self { name, path, span, runtime, module, member })
    }
}
