//! What `#[derive(ProcessImage)]` does: the image of a struct of PDOs.
//!
//! Only tokens are known here, no types; so lengths are sums of constants, and what the device forbids is found when
//! these are evaluated.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Error, Expr, Result, Visibility};

use super::errors::{all, both};
use super::expression::number;
use super::located;
use super::record::{Field, Record};
use super::settings::{Settings, Vocabulary};

const IMAGE: Vocabulary = Vocabulary { attribute: "image", keys: &["runtime"], takes_entry: false };
const FIELD: Vocabulary = Vocabulary { attribute: "image", keys: &["axis"], takes_entry: false };

const EXPECTED: &str =
    "expected a struct with named fields, such as `pub struct Outputs { pub axes: [RxPdo1600; 6] }`";

/// Expands the derive on a struct whose fields are PDOs or arrays of PDOs.
pub fn process_image(input: TokenStream) -> TokenStream {
    let image = Record::parse(input, EXPECTED).and_then(Image::of);
    image.map_or_else(Error::into_compile_error, |image| image.tokens())
}

/// A process image.
struct Image {
    name: Ident,
    visibility: Visibility,
    /// The path of the runtime crate.
    runtime: TokenStream,
    parts: Vec<Part>,
}

/// A field of it.
struct Part {
    name: Ident,
    /// Where its type is written.
    span: Span,
    pdo: TokenStream,
    /// How many in a row; one that is no array has none.
    count: Option<usize>,
    /// The axis of the first.
    axis: TokenStream,
    /// The first byte.
    offset: TokenStream,
    /// How many PDOs are before it.
    place: usize,
}

impl Image {
    fn of(record: Record) -> Result<Self> {
        let empty = "no PDO is in it: expected fields such as `pub axes: [RxPdo1600; 6]`";
        let runtime = Settings::parse(&record.attributes, &IMAGE).and_then(|settings| settings.runtime());
        let parts = all(record.fields.iter().map(Part::of));
        let (_, (runtime, mut parts)) = both(record.check(empty), both(runtime, parts))?;
        let (mut offset, mut place) = (quote!(0), 0);
        for part in &mut parts {
            (part.offset, part.place) = (offset, place);
            (offset, place) = (part.end(&runtime), place + part.number());
        }
        Ok(Self { name: record.name, visibility: record.visibility, runtime, parts })
    }

    fn tokens(&self) -> TokenStream {
        let (data, selection, checks, view) = (self.data(), self.selection(), self.checks(), self.view());
        quote!(#data #selection #checks #view)
    }

    /// The bytes of all, an expression.
    fn length(&self) -> TokenStream {
        self.parts.last().map(|part| part.end(&self.runtime)).unwrap_or_default()
    }

    /// The first PDO, which the others have to go with.
    fn first(&self) -> TokenStream {
        self.parts.first().map(|part| part.pdo.clone()).unwrap_or_default()
    }

    fn data(&self) -> TokenStream {
        let (name, runtime, length) = (&self.name, &self.runtime, self.length());
        let first = self.parts.first().map(|part| {
            let data = part.data(runtime);
            quote_spanned!(part.span=> type Device = #data::Device; type Direction = #data::Direction;)
        });
        let pack = self.parts.iter().map(|part| part.pack(runtime));
        let unpack = self.parts.iter().map(|part| part.unpack(runtime));
        quote! {
            impl #runtime::pdo::ProcessData for #name {
                #first
                type Image = [u8; #length];

                #[inline]
                fn pack(self) -> Self::Image {
                    const LENGTH: usize = <#name as #runtime::pdo::ProcessData>::LEN;
                    let mut image = [0; LENGTH];
                    #(#pack)*
                    image
                }

                #[inline]
                fn unpack(image: Self::Image) -> Self {
                    const LENGTH: usize = <#name as #runtime::pdo::ProcessData>::LEN;
                    Self { #(#unpack),* }
                }
            }

            #runtime::ethercrab!(#name, <#name as #runtime::pdo::ProcessData>::LEN);
        }
    }

    /// The PDOs, in order.
    fn selection(&self) -> TokenStream {
        let (name, runtime, first) = (&self.name, &self.runtime, &self.first());
        let pdos = self.parts.iter().flat_map(|part| {
            let runtime = located(runtime, part.span);
            (0..part.number()).map(move |number| {
                let (pdo, axis) = (&part.pdo, &part.axis);
                let number = Literal::u8_suffixed(u8::try_from(number).unwrap_or(u8::MAX));
                quote_spanned!(part.span=> #runtime::pdo::selected::<#first, #pdo>(#axis + #number))
            })
        });
        quote! {
            impl #runtime::pdo::ProcessImage for #name {
                const PDOS: &'static [#runtime::pdo::MappedPdo] = &[#(#pdos),*];
            }
        }
    }

    /// What the device forbids, each at the field that is too much.
    fn checks(&self) -> TokenStream {
        let (name, runtime) = (&self.name, &self.runtime);
        let of_parts = self.parts.iter().map(|part| {
            let runtime = &located(runtime, part.span);
            let checks = (part.place..part.place + part.number()).map(|place| {
                let place = Literal::usize_unsuffixed(place);
                quote_spanned!(part.span=> #runtime::pdo::check_pdo::<#name>(#place);)
            });
            quote_spanned!(part.span=> const _: () = { #(#checks)* };)
        });
        let runtime = located(runtime, self.name.span());
        let whole = quote_spanned! {self.name.span()=>
            const _: () = #runtime::pdo::check_image::<#name>();
        };
        quote!(#(#of_parts)* #whole)
    }

    fn view(&self) -> TokenStream {
        let (name, runtime, visibility) = (&self.name, &self.runtime, &self.visibility);
        let view = format_ident!("{}View", name);
        let lines = self.parts.iter().map(Part::line);
        quote! {
            #runtime::view! {
                #visibility #view of PDOs in #name, <#name as #runtime::pdo::ProcessData>::LEN;
                #(#lines)*
            }
        }
    }
}

impl Part {
    /// A field that has no place yet.
    fn of(field: &Field) -> Result<Self> {
        let axis = Settings::parse(&field.attributes, &FIELD).and_then(|settings| {
            let number = |axis: &Expr| {
                let here = Span::call_site().located_at(axis.span());
                quote_spanned!(here=> ((#axis) as u8))
            };
            Ok(settings.value("axis")?.map_or_else(|| quote!(0), number))
        });
        let (pdo, count) = match field.array() {
            Some((pdo, count)) => (pdo, number(count, "PDOs").map(|count| Some(count.into()))),
            None => (&field.content, Ok(None)),
        };
        let (axis, count) = both(axis, count)?;
        Ok(Self {
            name: field.name.clone(),
            span: field.span(),
            pdo: pdo.to_token_stream(),
            count,
            axis,
            offset: TokenStream::new(),
            place: 0,
        })
    }

    /// Its PDO as process data: what follows is an item of the trait.
    fn data(&self, runtime: &TokenStream) -> TokenStream {
        let (pdo, runtime) = (&self.pdo, located(runtime, self.span));
        quote_spanned!(self.span=> <#pdo as #runtime::pdo::ProcessData>)
    }

    /// The byte behind it, an expression.
    fn end(&self, runtime: &TokenStream) -> TokenStream {
        let (offset, data) = (&self.offset, self.data(runtime));
        let factor = Literal::usize_unsuffixed(self.number());
        quote!(#offset + #factor * #data::LEN)
    }

    /// How many PDOs it is.
    fn number(&self) -> usize {
        self.count.unwrap_or(1)
    }

    /// A variable for each PDO of a row.
    fn variables(&self, count: usize) -> Vec<Ident> {
        (0..count).map(|number| format_ident!("pdo_{number}")).collect()
    }

    /// The row of the image that it is, as an expression.
    fn row(&self, runtime: &TokenStream, count: usize, row: &str, image: &TokenStream) -> TokenStream {
        let (data, offset, row) = (self.data(runtime), &self.offset, format_ident!("{row}"));
        quote!(#runtime::pdo::place::#row::<{ #data::LEN }, #count, { #offset }, LENGTH>(#image))
    }

    fn pack(&self, runtime: &TokenStream) -> TokenStream {
        let (name, offset, data) = (&self.name, &self.offset, self.data(runtime));
        let Some(count) = self.count else {
            return quote! {
                *#runtime::pdo::place::part_mut::<_, { #offset }, LENGTH>(&mut image) = #data::pack(self.#name);
            };
        };
        let row = self.row(runtime, count, "row_mut", &quote!(&mut image));
        let variables = self.variables(count);
        let places: Vec<Ident> = (0..count).map(|number| format_ident!("place_{number}")).collect();
        quote! {
            let [#(#variables),*] = self.#name;
            let [#(#places),*] = #row;
            #(*#places = #data::pack(#variables);)*
        }
    }

    fn unpack(&self, runtime: &TokenStream) -> TokenStream {
        let (name, offset, data) = (&self.name, &self.offset, self.data(runtime));
        let unpack = quote!(#data::unpack);
        let Some(count) = self.count else {
            return quote!(#name: #unpack(*#runtime::pdo::place::part::<_, { #offset }, LENGTH>(&image)));
        };
        let (row, variables) = (self.row(runtime, count, "row", &quote!(&image)), self.variables(count));
        quote!(#name: { let [#(#variables),*] = #row; [#(#unpack(*#variables)),*] })
    }

    /// The line of the view.
    fn line(&self) -> TokenStream {
        let (name, pdo, offset) = (&self.name, &self.pdo, &self.offset);
        let name_mut = format_ident!("{}_mut", name);
        let content = match self.count {
            Some(count) => {
                let variables = self.variables(count);
                quote!([#pdo; #(#variables),*])
            }
            None => quote!((#pdo)),
        };
        quote!(#name, #name_mut: #content => #offset;)
    }
}
