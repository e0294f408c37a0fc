//! What `#[derive(Pdo)]` does: process data of a struct whose fields are entries mapped to a free PDO, with gaps where
//! the user wants them.
//!
//! The description is not read again: that an entry is there, is this device's, has the field's type and may be
//! mapped is in the types of the device's module, and its limits are in constants.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::{Error, Path, Result, Type, Visibility};

use super::choice::Choice;
use super::errors::{all, both};
use super::located;
use super::record::{Field, Record};
use super::settings::{Settings, Vocabulary};

const FIELD: Vocabulary = Vocabulary { attribute: "pdo", keys: &["gap"], takes_entry: true };

const EXPECTED: &str = "expected a struct with named fields, such as `#[pdo(mapping = s700::FreeRxPdo1600)] pub struct Setpoints { pub controlword: Controlword }`";

/// Expands the derive on a struct whose fields are entries.
pub fn own_pdo(input: TokenStream) -> TokenStream {
    let pdo = Record::parse(input, EXPECTED).and_then(OwnPdo::of);
    pdo.map_or_else(Error::into_compile_error, |pdo| pdo.tokens())
}

/// A PDO mapped by the user.
struct OwnPdo {
    name: Ident,
    visibility: Visibility,
    /// The path of the runtime crate.
    runtime: TokenStream,
    /// The type of the free PDO.
    free: Path,
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
    content: Type,
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
    fn of(record: Record) -> Result<Self> {
        let empty = "nothing is mapped: expected fields such as `pub controlword: Controlword`";
        let settings = all(record.fields.iter().map(|field| {
            let settings = Settings::parse(&field.attributes, &FIELD)?;
            Ok((settings.number("gap", "bits")?, settings.entry))
        }));
        let (_, (choice, settings)) = both(record.check(empty), both(Choice::of(&record), settings))?;
        let (mut fields, mut offset) = (Vec::new(), quote!(0));
        for (field, (gap, entry)) in record.fields.into_iter().zip(settings) {
            let entry = choice.entry(&field.name, entry);
            let mapped = Mapped::of(field, gap, entry, &offset, &choice.runtime);
            offset = mapped.end.clone();
            fields.push(mapped);
        }
        let Choice { runtime, free, axis, gap } = choice;
        Ok(Self { name: record.name, visibility: record.visibility, runtime, free, axis, fields, gap })
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
                    const MEMBERS: #runtime::pdo::Members =
                        <#free as #runtime::pdo::MappingObject>::MEMBERS;
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
        let span = free.segments.last().map_or_else(|| self.name.span(), |name| name.ident.span());
        let runtime = located(runtime, span);
        let whole = quote_spanned!(span=> const _: () = #runtime::pdo::check_mapping::<#free>(#axes););
        quote!(#(#limits)* #whole)
    }

    fn view(&self) -> TokenStream {
        let (name, runtime, visibility, length) =
            (&self.name, &self.runtime, &self.visibility, self.length());
        let view = format_ident!("{}View", name);
        let lines = self.fields.iter().map(|field| {
            let (name, content, offset) = (&field.name, &field.content, &field.offset);
            let setter = format_ident!("set_{}", name);
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
        field: Field,
        gap: Option<u8>,
        entry: TokenStream,
        offset: &TokenStream,
        runtime: &TokenStream,
    ) -> Self {
        let (span, Field { name, content, .. }) = (field.span(), field);
        let offset = behind(offset.clone(), gap);
        let end = quote!(#offset + <#content as #runtime::object::Value>::BITS);
        Self { span, name, content, gap, entry, offset, end }
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
