//! What `#[derive(Pdo)]` does: process data of a struct whose fields are entries mapped to a free PDO, with gaps where
//! the user wants them.
//!
//! The description is not read again: that an entry is there, is this device's, has the field's type and may be
//! mapped is in the types of the device's module, and its limits are in constants.

use proc_macro2::{Delimiter, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{format_ident, quote, quote_spanned};

use super::item::Form;
use super::record::{Field, Record};
use super::settings::Settings;
use super::{Fault, located};

const FORM: Form = Form {
    attribute: "pdo",
    expected: "expected a struct with named fields and no generics, such as `#[pdo(mapping = s700::FreeRxPdo1600)] pub struct Setpoints { pub controlword: Controlword }`",
};

/// Expands the derive on a struct whose fields are entries.
pub fn own_pdo(input: TokenStream) -> TokenStream {
    let pdo = Record::parse(input, &FORM).and_then(|record| OwnPdo::of(&record));
    pdo.map_or_else(|fault| fault.tokens(), |pdo| pdo.tokens())
}

/// A PDO mapped by the user.
struct OwnPdo {
    name: Ident,
    visibility: TokenStream,
    /// The path of the runtime crate.
    runtime: TokenStream,
    /// The type of the free PDO.
    free: TokenStream,
    /// The type of the axes, if each has the PDO.
    axis: Option<TokenStream>,
    fields: Vec<Mapped>,
    /// Bits behind the last field.
    gap: Option<u8>,
}

/// A field of it.
struct Mapped {
    name: Ident,
    span: Span,
    content: TokenStream,
    /// Bits in front of it.
    gap: Option<u8>,
    /// The typed entry, an expression, in which there may be an `axis`.
    entry: TokenStream,
    /// The first bit.
    offset: TokenStream,
    /// The bit behind it.
    end: TokenStream,
}

impl OwnPdo {
    fn of(record: &Record) -> Result<Self, Fault> {
        let settings = Settings::parse(&record.attributes, &["mapping", "per_axis", "gap", "runtime"])?;
        let runtime = settings.runtime()?;
        let missing = || {
            Fault::new(record.name.span(), "which PDO is mapped? Add `#[pdo(mapping = s700::FreeRxPdo1600)]`")
        };
        let free = settings.get("mapping").cloned().ok_or_else(missing)?;
        if record.fields.is_empty() {
            let message = "nothing is mapped: expected fields such as `pub controlword: Controlword`";
            return Err(Fault::new(record.name.span(), message));
        }
        let module = parent(&free);
        let axis = settings.get("per_axis").map(|_| quote!(#module Axis));
        let (mut fields, mut offset) = (Vec::new(), quote!(0));
        for field in &record.fields {
            let mapped = Mapped::of(field, &module, axis.is_some(), &offset, &runtime)?;
            offset = mapped.end.clone();
            fields.push(mapped);
        }
        Ok(Self {
            name: record.name.clone(),
            visibility: record.visibility.clone(),
            runtime,
            free,
            axis,
            fields,
            gap: settings.number("gap", "bits")?,
        })
    }

    fn tokens(&self) -> TokenStream {
        let (data, pdo, checks, view) = (self.data(), self.pdo(), self.checks(), self.view());
        quote!(#data #pdo #checks #view)
    }

    /// The bit behind all.
    fn end(&self) -> TokenStream {
        let end = self.fields.last().map(|field| field.end.clone()).unwrap_or_default();
        behind(end, self.gap)
    }

    /// The bytes of all, an expression.
    fn length(&self) -> TokenStream {
        let end = self.end();
        quote!((#end).div_ceil(8))
    }

    /// How many entries and gaps there are.
    fn count(&self) -> usize {
        self.fields.iter().map(Mapped::count).sum::<usize>() + usize::from(self.gap.is_some())
    }

    fn data(&self) -> TokenStream {
        let (name, runtime, free, length) = (&self.name, &self.runtime, &self.free, self.length());
        let pack = self.fields.iter().map(|field| {
            let (name, place) = (&field.name, field.place(runtime));
            quote!(#runtime::pdo::place::store::<#place, LENGTH>(&mut image, self.#name);)
        });
        let unpack = self.fields.iter().map(|field| {
            let (name, place) = (&field.name, field.place(runtime));
            quote!(#name: #runtime::pdo::place::load::<#place, LENGTH>(&image))
        });
        quote! {
            impl #runtime::pdo::ProcessData for #name {
                type Device = <#free as #runtime::pdo::MappingObject>::Device;
                type Direction = <#free as #runtime::pdo::MappingObject>::Direction;
                type Image = [u8; #length];

                #[inline]
                fn pack(self) -> Self::Image {
                    const LENGTH: usize = #length;
                    let mut image = [0; LENGTH];
                    #(#pack)*
                    image
                }

                #[inline]
                fn unpack(image: Self::Image) -> Self {
                    const LENGTH: usize = #length;
                    Self { #(#unpack),* }
                }
            }

            #runtime::ethercrab!(#name, #length);
        }
    }

    /// How many axes there are, and the words that find the one of a number.
    fn axes(&self) -> (TokenStream, TokenStream) {
        match &self.axis {
            Some(axis) => (quote!(#axis::ALL.len()), quote!(let axis = #axis::ALL[number];)),
            None => (quote!(1), TokenStream::new()),
        }
    }

    /// The lines of the mapping, with an `axis` if there are some.
    fn rows(&self) -> TokenStream {
        let (runtime, free) = (&self.runtime, &self.free);
        let gap = |bits: &u8| quote!(#runtime::pdo::Mapping::gap(#bits),);
        let of_fields = self.fields.iter().map(|field| {
            let (content, entry, runtime) = (&field.content, &field.entry, located(runtime, field.span));
            let gap = field.gap.iter().map(gap);
            let entry = quote_spanned!(field.span=> #runtime::pdo::mapped::<#free, #content, _, _>(#entry),);
            quote!(#(#gap)* #entry)
        });
        of_fields.chain(self.gap.iter().map(gap)).collect()
    }

    /// Index and mapping, on each axis if there are some.
    fn pdo(&self) -> TokenStream {
        let (name, runtime, free) = (&self.name, &self.runtime, &self.free);
        let (count, rows) = (Literal::usize_unsuffixed(self.count()), self.rows());
        let (axes, axis) = self.axes();
        quote! {
            const _: () = {
                const AXES: usize = #axes;
                const TABLE: &[[#runtime::pdo::Mapping; #count]; AXES] = &{
                    let none = #runtime::pdo::Mapping::gap(0);
                    let mut table = [[none; #count]; AXES];
                    let mut number = 0;
                    while number < AXES {
                        #axis
                        table[number] = [#rows];
                        number += 1;
                    }
                    table
                };

                impl #runtime::pdo::Pdo for #name {
                    const INDEX: u16 = <#free as #runtime::pdo::MappingObject>::INDICES[0];
                    const MAPPING: &'static [#runtime::pdo::Mapping] = &TABLE[0];
                    const ALL: &'static [#runtime::pdo::MappedPdo] =
                        &#runtime::pdo::own::<#free, #count, AXES>(TABLE);
                }
            };
        }
    }

    /// What is too much, each at the field with which it is.
    fn checks(&self) -> TokenStream {
        let (runtime, free) = (&self.runtime, &self.free);
        let mut number = 0;
        let of_fields = self.fields.iter().map(|field| {
            number += field.count();
            (field.span, number, field.end.clone())
        });
        let of_gap = self.gap.map(|_| (self.name.span(), self.count(), self.end()));
        let limits: Vec<TokenStream> = of_fields
            .chain(of_gap)
            .map(|(span, number, end)| {
                let (number, runtime) = (Literal::usize_unsuffixed(number), located(runtime, span));
                quote_spanned!(span=> const _: () = #runtime::pdo::check_entry::<#free>(#number, #end);)
            })
            .collect();
        let (axes, _) = self.axes();
        let span = free.clone().into_iter().last().map_or_else(|| self.name.span(), |token| token.span());
        let runtime = located(runtime, span);
        let whole = quote_spanned!(span=> const _: () = #runtime::pdo::check_mapping::<#free>(#axes););
        quote!(#(#limits)* #whole)
    }

    fn view(&self) -> TokenStream {
        let (name, runtime, visibility, length) =
            (&self.name, &self.runtime, &self.visibility, self.length());
        let view = format_ident!("{name}View");
        let lines = self.fields.iter().map(|field| {
            let (name, content, offset) = (&field.name, &field.content, &field.offset);
            let setter = format_ident!("set_{}", name.to_string().trim_start_matches("r#"));
            quote!(#name, #setter: #content => #offset, <#content as #runtime::object::Value>::BITS;)
        });
        quote! {
            #runtime::view! {
                #visibility #view of #name, #length;
                #(#lines)*
            }
        }
    }
}

impl Mapped {
    fn of(
        field: &Field,
        module: &TokenStream,
        per_axis: bool,
        offset: &TokenStream,
        runtime: &TokenStream,
    ) -> Result<Self, Fault> {
        let (name, content) = (field.name.clone(), field.content.clone());
        let (entry, settings) = Settings::beside(&field.attributes, &["gap"])?;
        let entry = match entry {
            Some(entry) => entry,
            None => {
                let id = name.to_string();
                let id = id.trim_start_matches("r#");
                let id = if per_axis { id.to_owned() } else { id.to_ascii_uppercase() };
                let (constant, module) = (Ident::new(&id, name.span()), located(module, name.span()));
                quote!(#module objects::#constant)
            }
        };
        let entry = if per_axis && is_function(&entry) { quote!(#entry(axis)) } else { entry };
        let gap = settings.number("gap", "bits")?;
        let offset = behind(offset.clone(), gap);
        let end = quote!(#offset + <#content as #runtime::object::Value>::BITS);
        Ok(Self { span: field.span(), name, content, gap, entry, offset, end })
    }

    /// How many lines of the mapping it takes.
    fn count(&self) -> usize {
        1 + usize::from(self.gap.is_some())
    }

    /// Type, first bit and number of bits, as generic arguments.
    fn place(&self, runtime: &TokenStream) -> TokenStream {
        let (content, offset) = (&self.content, &self.offset);
        quote!(#content, { #offset }, { <#content as #runtime::object::Value>::BITS })
    }
}

/// The bit behind a gap.
fn behind(bit: TokenStream, gap: Option<u8>) -> TokenStream {
    match gap.map(Literal::u8_unsuffixed) {
        Some(gap) => quote!(#bit + #gap),
        None => bit,
    }
}

/// The path of what a type is in, with the colons behind it; nothing if it is named alone.
fn parent(path: &TokenStream) -> TokenStream {
    let tokens: Vec<TokenTree> = path.clone().into_iter().collect();
    let length = tokens.len().saturating_sub(1);
    tokens.into_iter().take(length).collect()
}

/// Whether a path names a function: constants are in capitals, and what is called has its arguments already.
fn is_function(path: &TokenStream) -> bool {
    match path.clone().into_iter().last() {
        Some(TokenTree::Ident(name)) => name.to_string().chars().any(char::is_lowercase),
        Some(TokenTree::Group(group)) => group.delimiter() != Delimiter::Parenthesis,
        _ => false,
    }
}
