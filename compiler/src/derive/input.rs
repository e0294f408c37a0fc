//! Reading what the user wrote: a unit struct with a `device` attribute.

use proc_macro2::{Ident, Span, TokenStream};
use syn::parse::Parse;
use syn::{Data, DeriveInput, Error, Fields, LitStr, Result, Visibility};

use super::errors::{all, both};
use super::module_name;
use super::record::{check_generics, fields, item};
use super::settings::{Settings, Vocabulary};

const DEVICE: Vocabulary = Vocabulary {
    attribute: "device",
    keys: &["path", "runtime", "module", "member", "dictionary"],
    takes_entry: false,
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
    /// Whether the module has the dictionary for a firmware.
    pub(super) dictionary: bool,
}

impl Input {
    pub(super) fn parse(tokens: TokenStream) -> Result<Self> {
        let DeriveInput { attrs, vis, ident: name, generics, data } = item(tokens)?;
        let generics = check_generics(&name, &generics, "it stands for one device");
        let checks = all([check_form(data), check_visibility(&vis, &name), generics]);
        let settings = Settings::parse(&attrs, &DEVICE);
        let input = settings.and_then(|settings| Self::of(name, &settings));
        both(checks, input).map(|(_, input)| input)
    }

    fn of(name: Ident, settings: &Settings) -> Result<Self> {
        let add = "Add `#[device(path = \"devices/c887\")]`, a path from the folder of Cargo.toml";
        let missing = || Error::new(name.span(), format!("which device is `{name}`? {add}"));
        let path = settings.text("path").and_then(|path| path.ok_or_else(missing));
        let module = settings.name("module", Ident::parse, "name of a module");
        let names = both(settings.runtime(), module);
        let member = both(settings.text("member"), settings.choice("dictionary"));
        let ((path, (member, dictionary)), (runtime, module)) = both(both(path, member), names)?;
        Ok(Self {
            path: path.value(),
            span: path.span(),
            runtime,
            module: module.unwrap_or_else(|| module_name(&name)),
            member: member.map(LitStr::value),
            dictionary: dictionary.unwrap_or(true),
            name,
        })
    }
}

fn check_form(data: Data) -> Result<()> {
    let expected =
        "a device is a unit struct, such as `pub struct C887;`: the description is all there is to it";
    match fields(data, expected)? {
        Fields::Unit => Ok(()),
        fields => Err(Error::new_spanned(fields, expected)),
    }
}

fn check_visibility(visibility: &Visibility, name: &Ident) -> Result<()> {
    let why = "the types of its process data are public and name it";
    let message = format!("`{name}` has to be `pub struct {name};`: {why}");
    match visibility {
        Visibility::Public(_) => Ok(()),
        Visibility::Inherited => Err(Error::new(name.span(), message)),
        less => Err(Error::new_spanned(less, message)),
    }
}
