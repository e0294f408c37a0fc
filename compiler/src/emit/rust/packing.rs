//! Process data as it lies in the frame: packed and unpacked by value, and seen in place.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::bytes::{self, Place};
use super::literal::number;
use super::names::{Names, snake};
use super::scope::Scope;

/// How process data lies in the frame.
pub(super) struct Layout {
    /// Bytes of all.
    pub(super) length: u32,
    /// The body of `pack`.
    pub(super) pack: TokenStream,
    /// The argument of `unpack`.
    pub(super) pattern: TokenStream,
    /// The body of `unpack`.
    pub(super) unpack: TokenStream,
    /// What the view has, with the words before the struct.
    pub(super) view: (TokenStream, TokenStream),
    /// The attribute of `pack`.
    pub(super) inline: TokenStream,
}

impl Layout {
    /// Fields of bits. Their `pack` is always inlined, for an image of several PDOs takes the bytes of each apart: if
    /// they came back from a call, that would cost more than to pack them.
    pub(super) fn of_fields(places: &[Place], length: u32) -> Self {
        let (pack, pattern) = (bytes::pack(places, length), bytes::pattern(places, length));
        let (unpack, view) = (bytes::unpack(places), (quote!(of), fields(places)));
        Self { length, pack, pattern, unpack, view, inline: quote!(#[inline(always)]) }
    }
}

/// A line for each field: how it is read, how it is written, its type, its first bit and its bits.
fn fields(places: &[Place]) -> TokenStream {
    let mut names = Names::default();
    for name in places.iter().filter_map(|place| place.name.as_ref()) {
        names.claim(name);
    }
    let fields = places.iter().filter_map(|place| {
        let (name, value) = (place.name.as_ref()?, place.value.tokens());
        let setter = names.claim(&snake(&format!("set-{}", name.to_string().trim_start_matches("r#"))));
        let (offset, bits) = (number(place.offset), number(place.bits));
        Some(quote!(#name, #setter: #value => #offset, #bits;))
    });
    fields.collect()
}

/// Packing and unpacking, as constants and as the trait, and the view.
pub(super) fn items(scope: &Scope<'_>, name: &Ident, direction: TokenStream, layout: &Layout) -> TokenStream {
    let (runtime, owner, length) = (scope.runtime, &scope.owner, number(layout.length));
    let Layout { pack, pattern, unpack, view: (of, fields), inline, .. } = layout;
    let view = format_ident!("{name}View");
    quote! {
        impl #name {
            /// The fields as they are in the frame.
            #inline
            pub const fn pack(self) -> [u8; #length] {
                #pack
            }

            /// The fields out of the frame.
            #[inline]
            pub const fn unpack(#pattern: [u8; #length]) -> Self {
                #unpack
            }
        }

        #runtime::process_data!(#name: #owner, #direction, #length);

        #runtime::view! {
            pub #view #of #name, #length;
            #fields
        }
    }
}
