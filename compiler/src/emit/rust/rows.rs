//! A row of the table of objects as values: what is compared, and then written once.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::doc::Doc;
use super::item::{Item, Reach};
use super::literal::{number, parsed};
use super::scope::Scope;
use super::stored::Home;
use crate::model::{Access, DataType, Entry, Kind, Mappable, Object, Value, WriteWindow};

/// An object as the table has it; nothing in it depends on the high byte of its index.
#[derive(Debug, PartialEq)]
pub(super) struct Row {
    kind: Kind,
    /// Where its values are, if it has any that can change.
    place: Option<Place>,
    entries: Entries,
    /// The position of the values that cannot change among the constants.
    constants: usize,
}

#[derive(Debug, PartialEq)]
struct Place {
    /// The axis, counted from that of the page.
    axis: u8,
    field: u16,
}

#[derive(Debug, PartialEq)]
enum Entries {
    /// A number of entries, which never changes, and then entries that are all alike.
    List { count: usize, first: Option<usize>, attributes: Attributes },
    /// A number of entries, which can change, and then entries that are all alike, with the same rights.
    Counted { count: usize, attributes: Attributes },
    /// Each by itself.
    Single(Vec<Single>),
}

/// An entry: the position of its value among those of its object that can change.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Single {
    subindex: u8,
    item: Option<usize>,
    attributes: Attributes,
}

/// Type, length and rights.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Attributes {
    data_type: DataType,
    access: Access,
    /// The states in which it is written, if not in all.
    written: Option<WriteWindow>,
    pdo: Mappable,
}

/// The values of an object that never change, as an SDO carries them.
pub(super) fn constants(object: &Object, home: Option<&Home>) -> Vec<u8> {
    let fixed = object.entries.iter().filter(|entry| item(home, entry).is_none());
    let default =
        |entry: &Entry| entry.default.as_ref().unwrap_or(&Value::Integer(0)).little_endian(entry.data_type);
    fixed.flat_map(default).collect()
}

/// The position of a value among those of its object that can change.
fn item(home: Option<&Home>, entry: &Entry) -> Option<usize> {
    home?.subindices.iter().position(|subindex| *subindex == entry.address.subindex)
}

impl Row {
    /// The row of an object whose page counts axes from this one.
    pub(super) fn new(object: &Object, home: Option<&Home>, first_axis: u8, constants: usize) -> Self {
        let place = home.map(|home| {
            let axis = home.axis.map_or(0, |axis| axis.saturating_sub(first_axis));
            Place { axis, field: home.field }
        });
        Self { kind: object.kind, place, entries: Entries::of(object, home), constants }
    }

    /// Its line, and the name of the list of its entries if that needs lines of its own.
    pub(super) fn tokens(&self, object: &Object, lists: &mut Lists) -> (TokenStream, Option<Ident>) {
        let code = match self.kind {
            Kind::Var => quote!(VAR),
            Kind::Array => quote!(ARRAY),
            Kind::Record => quote!(RECORD),
        };
        let (name, constants) = (lists.name(object, &self.entries), number(self.constants));
        let entries = self.entries.tokens(name.as_ref());
        let row = match &self.place {
            None => quote!(constant(#code, #constants, #entries)),
            Some(Place { axis, field }) => {
                let (axis, field) = (number(*axis), number(*field));
                quote!(object(#code, #axis, #field, #constants, #entries))
            }
        };
        (row, name)
    }
}

impl Entries {
    fn of(object: &Object, home: Option<&Home>) -> Self {
        let single = |entry: &Entry| Single {
            subindex: entry.address.subindex,
            item: item(home, entry),
            attributes: Attributes::of(entry),
        };
        let entries: Vec<Single> = object.entries.iter().map(single).collect();
        Self::list(&entries).or_else(|| Self::counted(&entries)).unwrap_or(Self::Single(entries))
    }

    fn counted(entries: &[Single]) -> Option<Self> {
        let [count, items @ ..] = entries else { return None };
        let attributes = &items.first()?.attributes;
        let single = |subindex, item, attributes| Single { subindex, item: Some(item), attributes };
        let expected = (1..=u8::MAX).zip(1..).map(|(subindex, item)| single(subindex, item, *attributes));
        let number = single(0, 0, Attributes { data_type: Attributes::COUNT.data_type, ..*attributes });
        let is_counted = *count == number && expected.take(items.len()).eq(items.iter().copied());
        is_counted.then_some(Self::Counted { count: entries.len(), attributes: *attributes })
    }

    fn list(entries: &[Single]) -> Option<Self> {
        let [count, items @ ..] = entries else { return None };
        let Single { item: first, attributes, .. } = items.first()?;
        let place = |place: usize| first.map(|first| first.saturating_add(place));
        let expected = (1..=u8::MAX).zip(0..).map(|(subindex, item)| Single {
            subindex,
            item: place(item),
            attributes: *attributes,
        });
        let number = Single { subindex: 0, item: None, attributes: Attributes::COUNT };
        let is_list = *count == number && expected.take(items.len()).eq(items.iter().copied());
        is_list.then_some(Self::List { count: entries.len(), first: *first, attributes: *attributes })
    }

    /// The entries as an expression: their list by its name, if it has one.
    fn tokens(&self, name: Option<&Ident>) -> TokenStream {
        match self {
            Self::List { count, first, attributes } => {
                let (count, first, attributes) = (number(*count), position(*first), attributes.tokens());
                quote!(&list::<#count>(#first, #attributes))
            }
            Self::Counted { count, attributes } => {
                let (count, attributes) = (number(*count), attributes.tokens());
                quote!(&counted::<#count>(#attributes))
            }
            Self::Single(_) if name.is_some() => quote!(&#name),
            Self::Single(entries) => {
                let entries = entries.iter().map(Single::tokens);
                quote!(&[#(#entries),*])
            }
        }
    }
}

impl Single {
    fn tokens(&self) -> TokenStream {
        let (subindex, item) = (number(self.subindex), position(self.item));
        let attributes = self.attributes.tokens();
        quote!(entry(#subindex, #item, #attributes))
    }
}

/// Lists of entries that are told one by one, each once, named after the first object that has it.
#[derive(Default)]
pub(super) struct Lists(Vec<(Ident, Vec<Single>)>);

impl Lists {
    /// The name of a list that needs lines of its own.
    fn name(&mut self, object: &Object, entries: &Entries) -> Option<Ident> {
        let Entries::Single(entries) = entries else { return None };
        if entries.len() < 2 {
            return None;
        }
        let known = self.0.iter().find(|(_, known)| known == entries).map(|(name, _)| name.clone());
        Some(known.unwrap_or_else(|| {
            let name = format_ident!("ENTRIES_{:04X}", object.index.0);
            self.0.push((name.clone(), entries.clone()));
            name
        }))
    }

    pub(super) fn items<'s>(self, scope: &'s Scope<'_>) -> impl Iterator<Item = Item<'s>> {
        self.0.into_iter().map(move |(name, entries)| {
            let told = format!("{entries:?}");
            let item = Item::new(name.clone(), move || {
                let (within, count) = (&scope.within.0, number(entries.len()));
                let entries = entries.iter().map(Single::tokens);
                (Doc::default(), quote!(#within const #name: [EntryInfo; #count] = [#(#entries),*];))
            });
            item.reaching(Reach::Family).told(told)
        })
    }
}

fn position(item: Option<usize>) -> TokenStream {
    item.map(number).map_or_else(|| quote!(CONSTANT), |item| quote!(#item))
}

impl Attributes {
    /// Those of a number of entries.
    const COUNT: Self =
        Self { data_type: DataType::Uint(8), access: Access::Ro, written: None, pdo: Mappable::None };

    fn of(entry: &Entry) -> Self {
        let access = match entry.access {
            Access::Const => Access::Ro,
            access => access,
        };
        let written = entry.written.filter(|_| access != Access::Ro);
        Self { data_type: entry.data_type, access, written, pdo: entry.pdo }
    }

    fn tokens(self) -> TokenStream {
        let (data_type, bits) = (data_type(self.data_type), number(self.data_type.bits()));
        let access = self.rights();
        quote!(#data_type, #bits, #access)
    }

    /// Rights, with the state in which an entry is written that has only one.
    fn rights(self) -> TokenStream {
        let states = [quote!(PRE_OP), quote!(SAFE_OP), quote!(OP)];
        let write = self.written.and_then(|window| {
            let within = states.into_iter().zip(window.states()).filter(|(_, within)| *within);
            within.map(|(state, _)| state).reduce(|all, state| quote!(#all.and(#state)))
        });
        let rights = match (self.access, write) {
            (Access::Ro | Access::Const, _) => quote!(RO),
            (Access::Wo, None) => quote!(WO),
            (Access::Wo, Some(write)) => write,
            (Access::Rw, None) => quote!(RW),
            (Access::Rw, Some(write)) => quote!(RO.and(#write)),
        };
        match self.pdo {
            Mappable::None => rights,
            Mappable::Rx => quote!(#rights.and(RX)),
            Mappable::Tx => quote!(#rights.and(TX)),
            Mappable::RxTx => quote!(#rights.and(RX).and(TX)),
        }
    }
}

/// The number of the type, by name where the runtime has one.
fn data_type(data_type: DataType) -> TokenStream {
    let name = match data_type {
        DataType::Bool => "BOOL".to_owned(),
        DataType::Int(bits @ (8 | 16 | 32 | 64)) => format!("I{bits}"),
        DataType::Uint(bits @ (8 | 16 | 32 | 64)) => format!("U{bits}"),
        DataType::Int(bits) => format!("DataType::INTEGER{bits}"),
        DataType::Uint(bits) => format!("DataType::UNSIGNED{bits}"),
        DataType::Real32 => "F32".to_owned(),
        DataType::Real64 => "F64".to_owned(),
        DataType::Text(_) => "TEXT".to_owned(),
        DataType::Unicode(_) => "DataType::UNICODE_STRING".to_owned(),
        DataType::Octets(_) | DataType::Bitstring(_) | DataType::Bits(_) => {
            format!("DataType(0x{:04X})", data_type.code())
        }
    };
    parsed(&name)
}
