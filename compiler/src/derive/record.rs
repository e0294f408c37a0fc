//! Structs as users write them.

use proc_macro2::{Ident, Span, TokenStream};
use syn::spanned::Spanned;
use syn::{Attribute, Data, DeriveInput, Error, Expr, Fields, Generics, Result, Type, Visibility};

/// A struct with named fields.
pub(super) struct Record {
    pub(super) attributes: Vec<Attribute>,
    pub(super) visibility: Visibility,
    pub(super) name: Ident,
    generics: Generics,
    pub(super) fields: Vec<Field>,
}

/// A field of it.
pub(super) struct Field {
    pub(super) attributes: Vec<Attribute>,
    pub(super) name: Ident,
    pub(super) content: Type,
}

impl Field {
    fn of(field: syn::Field) -> Option<Self> {
        field.ident.map(|name| Self { attributes: field.attrs, name, content: field.ty })
    }

    /// The element and the number, if the field is an array.
    pub(super) fn array(&self) -> Option<(&Type, &Expr)> {
        match bare(&self.content) {
            Type::Array(array) => Some((&array.elem, &array.len)),
            _ => None,
        }
    }

    /// Where its type is written.
    pub(super) fn span(&self) -> Span {
        bare(&self.content).span()
    }
}

impl Record {
    /// Reads a struct; what is no such struct is told what is `expected`.
    pub(super) fn parse(tokens: TokenStream, expected: &str) -> Result<Self> {
        let DeriveInput { attrs: attributes, vis: visibility, ident: name, generics, data } = item(tokens)?;
        let fields = match fields(data, expected)? {
            Fields::Named(fields) => fields.named.into_iter().filter_map(Field::of).collect(),
            Fields::Unnamed(fields) => return Err(Error::new_spanned(fields, expected)),
            Fields::Unit => return Err(Error::new(name.span(), expected)),
        };
        Ok(Self { attributes, visibility, name, generics, fields })
    }

    /// Refuses generics, and a struct without fields.
    pub(super) fn check(&self, empty: &str) -> Result<()> {
        check_generics(&self.name, &self.generics, "where its bytes lie is settled here, once for all")?;
        if self.fields.is_empty() { Err(Error::new(self.name.span(), empty)) } else { Ok(()) }
    }
}

/// Reads a struct, an enum or a union. rustc has read it before; so what is refused is right, but beyond what syn reads
/// without its feature `full`, such as a branch in the length of an array.
pub(super) fn item(tokens: TokenStream) -> Result<DeriveInput> {
    let beyond = "the derive cannot read this: give it a name, as a constant or a type, and write that";
    syn::parse2(tokens).map_err(|error| Error::new(error.span(), beyond))
}

/// The fields of a struct; refuses what is none.
pub(super) fn fields(data: Data, expected: &str) -> Result<Fields> {
    match data {
        Data::Struct(data) => Ok(data.fields),
        Data::Enum(data) => Err(Error::new(data.enum_token.span, expected)),
        Data::Union(data) => Err(Error::new(data.union_token.span, expected)),
    }
}

/// Refuses parameters. A where clause without any holds, or rustc refuses the struct; so nothing depends on it.
pub(super) fn check_generics(name: &Ident, generics: &Generics, why: &str) -> Result<()> {
    if generics.params.is_empty() {
        return Ok(());
    }
    Err(Error::new_spanned(generics, format!("`{name}` cannot have generics: {why}")))
}

/// A type without the marks around it of a macro that it comes from, and without parentheses.
fn bare(mut content: &Type) -> &Type {
    loop {
        content = match content {
            Type::Group(group) => &group.elem,
            Type::Paren(paren) => &paren.elem,
            content => return content,
        }
    }
}
