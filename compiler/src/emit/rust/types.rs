//! The Rust types of entries.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::literal;
use super::names::{Names, camel};
use crate::model::{Address, DataType, Device, Entry, Index, Object};

/// A type of Rust that holds a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Primitive {
    Bool,
    Signed(u8),
    Unsigned(u8),
    Real(u8),
    /// Anything of so many bytes that Rust has no type for.
    Bytes(u32),
    Text,
}

impl Primitive {
    pub(super) fn of(data_type: DataType) -> Self {
        match data_type {
            DataType::Bool | DataType::Bits(1) => Self::Bool,
            DataType::Int(bits) if native(bits) => Self::Signed(bits),
            DataType::Uint(bits) | DataType::Bitstring(bits) if native(bits) => Self::Unsigned(bits),
            DataType::Bits(_) => Self::Unsigned(8),
            DataType::Real32 => Self::Real(32),
            DataType::Real64 => Self::Real(64),
            DataType::Text(_) => Self::Text,
            DataType::Int(_) | DataType::Uint(_) | DataType::Bitstring(_) => Self::Bytes(data_type.bytes()),
        }
    }

    /// Its name in Rust.
    pub(super) fn tokens(self) -> TokenStream {
        let named = |letter: &str, bits: u8| {
            let name = format_ident!("{letter}{bits}");
            quote!(#name)
        };
        match self {
            Self::Bool => quote!(bool),
            Self::Signed(bits) => named("i", bits),
            Self::Unsigned(bits) => named("u", bits),
            Self::Real(bits) => named("f", bits),
            Self::Bytes(length) => {
                let length = literal::number(length);
                quote!([u8; #length])
            }
            Self::Text => quote!(str),
        }
    }

    /// Whether it counts.
    fn is_number(self) -> bool {
        matches!(self, Self::Signed(_) | Self::Unsigned(_))
    }
}

fn native(bits: u8) -> bool {
    matches!(bits, 8 | 16 | 32 | 64)
}

/// The type of a value in generated code: a primitive, or a struct around it.
#[derive(Debug, Clone)]
pub(super) struct ValueType {
    pub(super) primitive: Primitive,
    pub(super) newtype: Option<Ident>,
}

impl ValueType {
    /// Its name in generated code; the borrowed text for a text.
    pub(super) fn tokens(&self) -> TokenStream {
        match &self.newtype {
            Some(newtype) => quote!(#newtype),
            None => self.primitive.tokens(),
        }
    }

    /// The type of a field that holds it.
    pub(super) fn field(&self) -> TokenStream {
        match self.primitive {
            Primitive::Text => quote!(&'static str),
            _ => self.tokens(),
        }
    }

    /// A value of it from one of its primitive.
    pub(super) fn wrap(&self, value: TokenStream) -> TokenStream {
        match &self.newtype {
            Some(newtype) => quote!(#newtype(#value)),
            None => value,
        }
    }

    /// The primitive in a value of it.
    pub(super) fn unwrap(&self, value: TokenStream) -> TokenStream {
        match &self.newtype {
            Some(_) => quote!(#value.0),
            None => value,
        }
    }
}

/// An entry whose values have names.
#[derive(Debug)]
pub(super) struct Code<'a> {
    pub(super) name: Ident,
    pub(super) primitive: Primitive,
    pub(super) entry: &'a Entry,
}

/// The structs around numbers that entries have as their types.
#[derive(Debug, Default)]
pub(super) struct Types<'a> {
    newtypes: BTreeMap<Address, Ident>,
    /// The addresses of words: bits have no sign, whatever the manual calls their type.
    words: Vec<Address>,
    pub(super) codes: Vec<Code<'a>>,
    /// The name of each of these, by what it is and what its values mean.
    known: BTreeMap<(Primitive, &'a str, Meanings<'a>), Ident>,
}

/// Values with the words for them.
type Meanings<'a> = Vec<(i64, &'a str)>;

impl<'a> Types<'a> {
    /// The types of a device's entries; those of axes are found by the address on the first.
    pub(super) fn of(device: &'a Device, names: &mut Names) -> Self {
        let mut types = Self::default();
        for word in &device.words {
            types.newtypes.insert(word.address, names.claim(&camel(&word.id)));
            types.words.push(word.address);
        }
        if !device.errors.is_empty() {
            types.newtypes.insert(address(0x603F), names.claim(&camel("error-code")));
        }
        types.add_homing_methods(device, names);
        for object in device.objects.iter().filter(|object| object.axis.unwrap_or(0) == 0) {
            for entry in &object.entries {
                types.add_code(object, entry, device, names);
            }
        }
        types
    }

    /// Homing methods have a type of their own, in 0x6098 and in the list of those that there are, 0x60E3.
    fn add_homing_methods(&mut self, device: &Device, names: &mut Names) {
        let is_number = |entry: &&Entry| Primitive::of(entry.data_type) == Primitive::Signed(8);
        if device.homing_methods.is_empty()
            || !device.entry(address(0x6098)).is_some_and(|entry| is_number(&entry))
        {
            return;
        }
        let name = names.claim(&camel("homing-method"));
        let listed = device.object(Index(0x60E3)).into_iter().flat_map(|object| &object.entries);
        let listed = listed.filter(|entry| entry.address.subindex > 0).filter(is_number);
        for place in listed.map(|entry| entry.address).chain([address(0x6098)]) {
            self.newtypes.insert(place, name.clone());
        }
    }

    fn add_code(&mut self, object: &'a Object, entry: &'a Entry, device: &Device, names: &mut Names) {
        let primitive = Primitive::of(entry.data_type);
        // modes have an enum of their own, and what 0x6060 holds may be none of them
        let is_mode = !device.modes.is_empty() && [address(0x6060), address(0x6061)].contains(&entry.address);
        if entry.values.is_empty()
            || !primitive.is_number()
            || is_mode
            || self.newtypes.contains_key(&entry.address)
        {
            return;
        }
        let meanings = entry.values.iter().map(|meaning| (meaning.value, meaning.id.as_str())).collect();
        let what = (primitive, entry.id.as_str(), meanings);
        if let Some(name) = self.known.get(&what) {
            self.newtypes.insert(entry.address, name.clone());
            return;
        }
        let short = camel(&entry.id);
        let long = camel(&format!("{}-{}", object.id, entry.id));
        let name = names.claim(if names.has(&short) { &long } else { &short });
        self.newtypes.insert(entry.address, name.clone());
        self.known.insert(what, name.clone());
        self.codes.push(Code { name, primitive, entry });
    }

    /// The type at an address of the first axis.
    pub(super) fn at(&self, address: Option<Address>, data_type: DataType) -> ValueType {
        let newtype = address.and_then(|address| self.newtypes.get(&address)).cloned();
        let primitive = match Primitive::of(data_type) {
            Primitive::Signed(bits) if address.is_some_and(|address| self.words.contains(&address)) => {
                Primitive::Unsigned(bits)
            }
            primitive => primitive,
        };
        ValueType { primitive, newtype: newtype.filter(|_| primitive.is_number()) }
    }

    /// The struct around the number at an address of the first axis.
    pub(super) fn newtype(&self, address: Address) -> Option<&Ident> {
        self.newtypes.get(&address)
    }
}

/// Subindex 0 of an object.
pub(super) fn address(index: u16) -> Address {
    Address { index: Index(index), subindex: 0 }
}
