//! From fields to the bytes of a frame: one literal of all bytes, one pattern of all bytes.
//!
//! A field of whole bytes is bound byte by byte. A field of bits is shifted into the smallest number that holds it
//! and its neighbours' bits. Neither has an offset at run time that could be wrong.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::literal::{number, parsed};
use super::types::{Primitive, ValueType};

/// A field of process data.
#[derive(Debug)]
pub(super) struct Place {
    /// The field; none for padding.
    pub(super) name: Option<Ident>,
    pub(super) value: ValueType,
    /// The first bit.
    pub(super) offset: u32,
    /// The number of bits.
    pub(super) bits: u32,
}

impl Place {
    /// Whether it is whole bytes, those of its type.
    fn is_whole(&self) -> bool {
        let width = match self.value.primitive {
            Primitive::Bool | Primitive::Text => return false,
            Primitive::Signed(bits) | Primitive::Unsigned(bits) | Primitive::Real(bits) => bits.into(),
            Primitive::Bytes(length) => length * 8,
        };
        self.offset.is_multiple_of(8) && self.bits == width && width.is_multiple_of(8)
    }

    /// The bytes that it has bits in.
    fn bytes(&self) -> Vec<Ident> {
        (self.offset / 8..(self.offset + self.bits).div_ceil(8)).map(byte).collect()
    }

    /// Bits before it in its first byte.
    fn shift(&self) -> u32 {
        self.offset % 8
    }

    /// The width of the number that its bits are shifted in.
    fn container(&self) -> u32 {
        (self.shift() + self.bits).next_power_of_two().clamp(8, 128)
    }

    /// Its bits alone, in the lowest places of a container's value.
    fn masked(&self, value: TokenStream) -> TokenStream {
        if self.bits == self.container() {
            return value;
        }
        let mask = u128::MAX.checked_shr(128_u32.saturating_sub(self.bits)).unwrap_or(0);
        let mask = parsed(&format!("0x{mask:X}"));
        quote!(#value & #mask)
    }
}

/// The variable of a byte.
fn byte(number: u32) -> Ident {
    format_ident!("b{number}")
}

/// The body of `pack`.
pub(super) fn pack(places: &[Place], length: u32) -> TokenStream {
    let fields: Vec<(&Place, &Ident)> =
        places.iter().filter_map(|place| Some((place, place.name.as_ref()?))).collect();
    let mut bindings = Vec::new();
    let mut parts: Vec<Vec<Ident>> = vec![Vec::new(); length.try_into().unwrap_or(0)];
    for (number, (place, name)) in fields.iter().enumerate() {
        let names: Vec<Ident> = if place.is_whole() {
            place.bytes()
        } else {
            place.bytes().iter().map(|byte| format_ident!("f{number}_{byte}")).collect()
        };
        bindings.push(binding(place, name, &names));
        let first = usize::try_from(place.offset / 8).unwrap_or(0);
        for (part, name) in parts.iter_mut().skip(first).zip(names) {
            part.push(name);
        }
    }
    let bytes = parts.iter().map(|part| if part.is_empty() { quote!(0) } else { quote!(#(#part)|*) });
    quote!(#(#bindings)* [#(#bytes),*])
}

/// The bytes of a field, each bound to a name.
fn binding(place: &Place, name: &Ident, names: &[Ident]) -> TokenStream {
    let value = place.value.unwrap(quote!(self.#name));
    match place.value.primitive {
        Primitive::Bytes(_) if place.is_whole() => quote!(let [#(#names),*] = #value;),
        _ if place.is_whole() => quote!(let [#(#names),*] = #value.to_le_bytes();),
        primitive => {
            let width = place.container();
            let container = format_ident!("u{width}");
            let value = match primitive {
                Primitive::Real(_) => quote!(#value.to_bits()),
                _ => primitive.counted(value),
            };
            let masked = place.masked(quote!(#value as #container));
            let shifted = match place.shift() {
                0 => quote!((#masked)),
                shift => {
                    let shift = number(shift);
                    quote!(((#masked) << #shift))
                }
            };
            let rest = (names.len() * 8 < usize::try_from(width).unwrap_or(0)).then(|| quote!(, ..));
            quote!(let [#(#names),* #rest] = #shifted.to_le_bytes();)
        }
    }
}

/// The pattern of `unpack`: every byte that a field is in.
pub(super) fn pattern(places: &[Place], length: u32) -> TokenStream {
    let used: Vec<Ident> =
        places.iter().filter(|place| place.name.is_some()).flat_map(Place::bytes).collect();
    let bytes =
        (0..length).map(byte).map(|byte| if used.contains(&byte) { quote!(#byte) } else { quote!(_) });
    quote!([#(#bytes),*])
}

/// The fields of `unpack`.
pub(super) fn unpack(places: &[Place]) -> TokenStream {
    let fields = places.iter().filter_map(|place| {
        let name = place.name.as_ref()?;
        let value = place.value.wrap(from_bytes(place));
        Some(quote!(#name: #value))
    });
    quote!(Self { #(#fields),* })
}

fn from_bytes(place: &Place) -> TokenStream {
    let bytes = place.bytes();
    let primitive = place.value.primitive;
    let name = primitive.tokens();
    if place.is_whole() {
        return match primitive {
            Primitive::Bytes(_) => quote!([#(#bytes),*]),
            _ => quote!(#name::from_le_bytes([#(#bytes),*])),
        };
    }
    let width = place.container();
    let container = format_ident!("u{width}");
    let zeros = (bytes.len()..usize::try_from(width / 8).unwrap_or(0)).map(|_| quote!(0));
    let all = bytes.iter().map(|byte| quote!(#byte)).chain(zeros);
    let whole = quote!(#container::from_le_bytes([#(#all),*]));
    let shifted = match place.shift() {
        0 => whole,
        shift => {
            let shift = number(shift);
            quote!(#whole >> #shift)
        }
    };
    let raw = place.masked(shifted);
    match primitive {
        _ if !primitive.is_native() => quote!(#name::from_low_bits((#raw) as u64)),
        Primitive::Bool => quote!(#raw != 0),
        Primitive::Signed(_) => {
            let signed = format_ident!("i{width}");
            match width.saturating_sub(place.bits) {
                0 => quote!((#raw) as #name),
                up => {
                    // the sign is moved to the highest bit, and back with copies of it
                    let up = number(up);
                    quote!((((#raw) << #up) as #signed >> #up) as #name)
                }
            }
        }
        Primitive::Real(bits) => {
            let bits = format_ident!("u{bits}");
            quote!(#name::from_bits((#raw) as #bits))
        }
        _ => quote!((#raw) as #name),
    }
}
