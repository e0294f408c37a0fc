//! The Rust types of entries.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::literal;
use super::names::{Names, camel};
use crate::model::{Address, DataType, Device, Entry, Index, Object};

/// A type of Rust that holds a value; for whole numbers of a width that Rust has none for, one of the runtime.
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
            DataType::Int(bits) => Self::Signed(bits),
            DataType::Uint(bits) | DataType::Bitstring(bits) | DataType::Bits(bits) => Self::Unsigned(bits),
            DataType::Real32 => Self::Real(32),
            DataType::Real64 => Self::Real(64),
            DataType::Text(_) => Self::Text,
            DataType::Octets(_) | DataType::Unicode(_) | DataType::Array(..) => {
                Self::Bytes(data_type.bytes())
            }
        }
    }

    /// What is known to have so many bits and no more.
    pub(super) fn of_bits(bits: u32) -> Self {
        match u8::try_from(bits) {
            Ok(1) => Self::Bool,
            Ok(bits @ (2..=7 | 24 | 40 | 48 | 56)) => Self::Unsigned(bits),
            Ok(bits @ ..=64) => Self::Unsigned(bits.next_power_of_two().max(8)),
            _ => Self::Bytes(bits.div_ceil(8)),
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
            Self::Signed(bits) if self.is_native() => named("i", bits),
            Self::Unsigned(bits) if self.is_native() => named("u", bits),
            Self::Signed(bits) => named("Int", bits),
            Self::Unsigned(bits @ ..8) => named("Bit", bits),
            Self::Unsigned(bits) => named("Uint", bits),
            Self::Real(bits) => named("f", bits),
            Self::Bytes(length) => {
                let length = literal::number(length);
                quote!([u8; #length])
            }
            Self::Text => quote!(str),
        }
    }

    /// Whether it counts.
    pub(super) fn is_number(self) -> bool {
        matches!(self, Self::Signed(_) | Self::Unsigned(_))
    }

    /// Whether Rust has the type.
    pub(super) fn is_native(self) -> bool {
        match self {
            Self::Signed(bits) | Self::Unsigned(bits) => matches!(bits, 8 | 16 | 32 | 64),
            Self::Bool | Self::Real(_) | Self::Bytes(_) | Self::Text => true,
        }
    }

    /// A value of the type that is this number in a constant.
    pub(super) fn constant(self, number: TokenStream) -> TokenStream {
        if self.is_native() {
            return number;
        }
        let name = self.tokens();
        quote!(#name::of::<#number>())
    }

    /// The number that a value of the type is, as Rust counts.
    pub(super) fn counted(self, value: TokenStream) -> TokenStream {
        if self.is_native() { value } else { quote!(#value.get()) }
    }
}

/// The type of a value in generated code: a primitive, or a struct around it.
#[derive(Debug, Clone, PartialEq, Eq)]
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
        let is_word = address.is_some_and(|address| self.words.contains(&address));
        let primitive = match Primitive::of(data_type) {
            Primitive::Signed(bits) if is_word => Primitive::Unsigned(bits),
            primitive => primitive,
        };
        // the struct of a word is around a number of Rust's
        let fits = primitive.is_number() && (primitive.is_native() || !is_word);
        ValueType { primitive, newtype: newtype.filter(|_| fits) }
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
