//! A row of the table of objects as values: what is compared, and then written once.

use proc_macro2::TokenStream;
use quote::quote;

use super::literal::{number, parsed};
use super::stored::Home;
use crate::model::{Access, DataType, Entry, Kind, Mappable, Object, Value, WriteWindow};

/// An object as the table has it; nothing in it depends on the high byte of its index.
#[derive(PartialEq)]
pub(super) struct Row {
    kind: Kind,
    /// Where its values are, if it has any that can change.
    place: Option<Place>,
    entries: Entries,
    /// The position of the values that cannot change among the constants.
    constants: usize,
}

#[derive(PartialEq)]
struct Place {
    /// The axis, counted from that of the page.
    axis: u8,
    field: u16,
}

#[derive(PartialEq)]
enum Entries {
    /// A number of entries, which never changes, and then entries that are all alike.
    List { count: usize, first: Option<usize>, attributes: Attributes },
    /// A number of entries, which can change, and then entries that are all alike, with the same rights.
    Counted { count: usize, attributes: Attributes },
    /// Each by its subindex, with the position of its value among those of the object that can change.
    Single(Vec<(u8, Option<usize>, Attributes)>),
}

/// Type, length and rights.
#[derive(Clone, Copy, PartialEq)]
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

    pub(super) fn tokens(&self) -> TokenStream {
        let code = match self.kind {
            Kind::Var => quote!(ObjectCode::Variable),
            Kind::Array => quote!(ObjectCode::Array),
            Kind::Record => quote!(ObjectCode::Record),
        };
        let (entries, constants) = (self.entries.tokens(), number(self.constants));
        let Some(Place { axis, field }) = &self.place else {
            return quote!(constant(#code, #entries, #constants));
        };
        let (axis, field) = (number(*axis), number(*field));
        quote!(object(#code, #axis, #field, #entries, #constants))
    }
}

impl Entries {
    fn of(object: &Object, home: Option<&Home>) -> Self {
        let single = |entry: &Entry| (entry.address.subindex, item(home, entry), Attributes::of(entry));
        let entries: Vec<_> = object.entries.iter().map(single).collect();
        Self::list(&entries).or_else(|| Self::counted(&entries)).unwrap_or(Self::Single(entries))
    }

    fn counted(entries: &[(u8, Option<usize>, Attributes)]) -> Option<Self> {
        let [count, items @ ..] = entries else { return None };
        let (_, _, attributes) = items.first()?;
        let expected = (1..=u8::MAX).zip(1..).map(|(subindex, item)| (subindex, Some(item), *attributes));
        let number = (0, Some(0), Attributes { data_type: Attributes::COUNT.data_type, ..*attributes });
        let is_counted = *count == number && expected.take(items.len()).eq(items.iter().copied());
        is_counted.then_some(Self::Counted { count: entries.len(), attributes: *attributes })
    }

    fn list(entries: &[(u8, Option<usize>, Attributes)]) -> Option<Self> {
        let [count, items @ ..] = entries else { return None };
        let (_, first, attributes) = items.first()?;
        let place = |place: usize| first.map(|first| first.saturating_add(place));
        let expected = (1..=u8::MAX).zip(0..).map(|(subindex, item)| (subindex, place(item), *attributes));
        let is_list =
            *count == (0, None, Attributes::COUNT) && expected.take(items.len()).eq(items.iter().copied());
        is_list.then_some(Self::List { count: entries.len(), first: *first, attributes: *attributes })
    }

    fn tokens(&self) -> TokenStream {
        match self {
            Self::List { count, first, attributes } => {
                let (count, first, attributes) = (number(*count), position(*first), attributes.tokens());
                quote!(&const { EntryInfo::list::<#count>(#first, #attributes) })
            }
            Self::Counted { count, attributes } => {
                let (count, attributes) = (number(*count), attributes.tokens());
                quote!(&const { EntryInfo::counted::<#count>(#attributes) })
            }
            Self::Single(entries) => {
                let entries = entries.iter().map(|(subindex, item, attributes)| {
                    let (subindex, item) = (number(*subindex), position(*item));
                    let attributes = attributes.tokens();
                    quote!(entry(#subindex, #item, #attributes))
                });
                quote!(&[#(#entries),*])
            }
        }
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
        DataType::Bool => "DataType::BOOLEAN".to_owned(),
        DataType::Int(bits) => format!("DataType::INTEGER{bits}"),
        DataType::Uint(bits) => format!("DataType::UNSIGNED{bits}"),
        DataType::Real32 => "DataType::REAL32".to_owned(),
        DataType::Real64 => "DataType::REAL64".to_owned(),
        DataType::Text(_) => "DataType::VISIBLE_STRING".to_owned(),
        DataType::Unicode(_) => "DataType::UNICODE_STRING".to_owned(),
        DataType::Octets(_) | DataType::Bitstring(_) | DataType::Bits(_) | DataType::Array(..) => {
            format!("DataType(0x{:04X})", data_type.code())
        }
    };
    parsed(&name)
}
