//! The table that finds an entry by its address, as constant data.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::information;
use super::literal::{hex8, number, parsed};
use super::scope::Scope;
use super::stored::{Home, Stored, homes};
use crate::model::{Access, DataType, Entry, Index, Kind, Mappable, Object, Value};

/// Objects whose indices share the high byte.
pub(super) struct Page<'a> {
    pub(super) high: u8,
    objects: Vec<Row<'a>>,
}

/// An object, and where its values are if it has any that can change.
struct Row<'a> {
    object: &'a Object,
    home: Option<&'a Home>,
}

impl<'a> Page<'a> {
    /// The objects, ascending by index.
    pub(super) fn objects(&self) -> impl Iterator<Item = &'a Object> {
        self.objects.iter().map(|row| row.object)
    }

    fn lows(&self) -> impl Iterator<Item = u8> {
        self.objects.iter().map(|row| row.object.index.0.to_be_bytes()[1])
    }

    /// The axis from which the objects count theirs.
    fn axis(&self) -> u8 {
        self.objects.iter().filter_map(|row| row.home?.axis).min().unwrap_or(0)
    }

    /// The table of objects, which says nothing of the high byte: pages of axes that are alike have the same.
    fn table(&self, constants: &mut Constants) -> TokenStream {
        let objects = self.objects.iter().map(|row| row.tokens(self.axis(), constants));
        quote!([#(#objects),*])
    }

    fn first(&self) -> u8 {
        self.lows().next().unwrap_or(0)
    }

    /// The position of each low byte, from the first to the last.
    fn slots(&self) -> TokenStream {
        let last = self.lows().last().unwrap_or(0);
        let length = number(u16::from(last).saturating_sub(self.first().into()).saturating_add(1));
        let (first, lows) = (hex8(self.first()), self.lows().map(hex8));
        quote!([u8; #length] = positions(#first, &[#(#lows),*]))
    }
}

pub(super) fn items(scope: &Scope<'_>, stored: &[Stored<'_>]) -> TokenStream {
    let homes = homes(stored);
    let pages = pages(&scope.device.objects, &homes);
    let mut shared: Vec<(String, Ident)> = Vec::new();
    let (mut tables, mut rows) = (TokenStream::new(), Vec::new());
    let mut constants = Constants::default();
    for page in &pages {
        let table = page.table(&mut constants);
        let slots = page.slots();
        let key = format!("{table}{slots}");
        let known = shared.iter().find(|(known, _)| *known == key).map(|(_, name)| name.clone());
        let name = known.unwrap_or_else(|| {
            let name = format_ident!("PAGE_{:02X}", page.high);
            tables.extend(page_const(&name, page, &table, &slots));
            shared.push((key, name.clone()));
            name
        });
        let axis = number(page.axis());
        rows.push(quote!(Page { axis: #axis, ..#name }));
    }
    let highs = pages.iter().map(|page| hex8(page.high));
    let (shorthands, constants) = (shorthands(), constants.tokens());
    let information = scope.device.mailbox.as_ref().filter(|mailbox| mailbox.sdo_info);
    let names = information.map(|_| information::items(&pages));
    quote! {
        /// Every entry of the device, to be found by its address.
        pub static TABLE: sdo::Dictionary = sdo::Dictionary {
            directory: &DIRECTORY,
            pages: &[#(#rows),*],
            constants: &CONSTANTS,
        };

        const DIRECTORY: [u8; 256] = positions(0, &[#(#highs),*]);
        #constants
        #shorthands
        #tables
        #names
    }
}

fn pages<'a>(objects: &'a [Object], homes: &'a BTreeMap<Index, Home>) -> Vec<Page<'a>> {
    let mut pages: Vec<Page<'_>> = Vec::new();
    for object in objects {
        let [high, _] = object.index.0.to_be_bytes();
        let row = Row { object, home: homes.get(&object.index) };
        match pages.last_mut().filter(|page| page.high == high) {
            Some(page) => page.objects.push(row),
            None => pages.push(Page { high, objects: vec![row] }),
        }
    }
    pages
}

fn page_const(name: &Ident, page: &Page<'_>, table: &TokenStream, slots: &TokenStream) -> TokenStream {
    let (first, slots_name) = (hex8(page.first()), format_ident!("SLOTS_{:02X}", page.high));
    quote! {
        const #slots_name: #slots;

        const #name: Page = Page { first: #first, axis: 0, slots: &#slots_name, objects: &#table };
    }
}

/// What makes a line of each object and entry.
fn shorthands() -> TokenStream {
    quote! {
        const fn object(
            code: ObjectCode,
            axis: u8,
            field: u16,
            entries: &'static [EntryInfo],
            constants: u16,
        ) -> ObjectInfo {
            ObjectInfo { code, axis, field, entries, constants }
        }

        const fn constant(
            code: ObjectCode,
            entries: &'static [EntryInfo],
            constants: u16,
        ) -> ObjectInfo {
            object(code, 0, 0, entries, constants)
        }

        const fn entry(subindex: u8, item: u8, data_type: DataType, bits: u16, access: Access) -> EntryInfo {
            EntryInfo { subindex, item, data_type, bits, access }
        }

        const CONSTANT: u8 = EntryInfo::CONSTANT;
        const RO: Access = Access::READ;
        const WO: Access = Access::WRITE;
        const RW: Access = RO.and(WO);
        const PRE_OP: Access = Access::WRITE_PRE_OPERATIONAL;
        const SAFE_OP: Access = Access::WRITE_SAFE_OPERATIONAL;
        const OP: Access = Access::WRITE_OPERATIONAL;
        const RX: Access = Access::RX_PDO;
        const TX: Access = Access::TX_PDO;
    }
}

/// The values that never change, those of all objects in a row.
#[derive(Default)]
struct Constants {
    bytes: Vec<u8>,
    known: BTreeMap<Vec<u8>, usize>,
}

impl Constants {
    /// Where the values of an object are; the same bytes serve for all objects that have them.
    fn position(&mut self, values: Vec<u8>) -> usize {
        if values.is_empty() {
            return 0;
        }
        *self.known.entry(values).or_insert_with_key(|values| {
            let end = self.bytes.len();
            self.bytes.extend(values);
            end
        })
    }

    fn tokens(&self) -> TokenStream {
        let (count, bytes) = (number(self.bytes.len()), self.bytes.iter().map(|byte| hex8(*byte)));
        quote!(const CONSTANTS: [u8; #count] = [#(#bytes),*];)
    }
}

impl Row<'_> {
    /// The object on a page whose objects count their axis from this one.
    fn tokens(&self, axis: u8, constants: &mut Constants) -> TokenStream {
        let code = match self.object.kind {
            Kind::Var => quote!(ObjectCode::Variable),
            Kind::Array => quote!(ObjectCode::Array),
            Kind::Record => quote!(ObjectCode::Record),
        };
        let constants = number(constants.position(self.constants()));
        let entries = match self.list() {
            Some(list) => quote!(&const { #list }),
            None => {
                let entries = self.object.entries.iter().map(|it| entry(it, self.item(it)));
                quote!(&[#(#entries),*])
            }
        };
        let Some(home) = self.home else { return quote!(constant(#code, #entries, #constants)) };
        let own = home.axis.map_or(0, |own| own.saturating_sub(axis));
        let (axis, field) = (number(own), number(home.field));
        quote!(object(#code, #axis, #field, #entries, #constants))
    }

    /// The position among the values that can change.
    fn item(&self, entry: &Entry) -> Option<usize> {
        self.home?.subindices.iter().position(|subindex| *subindex == entry.address.subindex)
    }

    /// The values that cannot.
    fn constants(&self) -> Vec<u8> {
        let fixed = self.object.entries.iter().filter(|entry| self.item(entry).is_none());
        fixed.flat_map(bytes).collect()
    }

    /// The entries of an object that has a number of entries, which never changes, and after that entries all alike.
    fn list(&self) -> Option<TokenStream> {
        let (count, items) = self.object.entries.split_first()?;
        let first = items.first()?;
        let is_count = count.data_type == DataType::Uint(8) && access(count).to_string() == "RO";
        let mut in_a_row = self.object.entries.iter().zip(0..=u8::MAX);
        let in_a_row = in_a_row.all(|(entry, subindex)| entry.address.subindex == subindex);
        let alike = |it: &Entry| attributes(it).to_string() == attributes(first).to_string();
        let from = self.item(first);
        let places = |(it, place)| self.item(it) == from.map(|from| from.saturating_add(place));
        let is_list = is_count
            && self.item(count).is_none()
            && in_a_row
            && items.iter().all(alike)
            && items.iter().zip(0..).all(places);
        let (length, from, attributes) = (number(self.object.entries.len()), place(from), attributes(first));
        is_list.then(|| quote!(EntryInfo::list::<#length>(#from, #attributes)))
    }
}

/// The default in the bytes of the type.
fn bytes(entry: &Entry) -> Vec<u8> {
    let default = entry.default.as_ref().unwrap_or(&Value::Integer(0));
    default.little_endian(entry.data_type)
}

fn entry(entry: &Entry, item: Option<usize>) -> TokenStream {
    let (subindex, item, attributes) = (number(entry.address.subindex), place(item), attributes(entry));
    quote!(entry(#subindex, #item, #attributes))
}

/// The position of a value among those of its object that can change.
fn place(item: Option<usize>) -> TokenStream {
    item.map(number).map_or_else(|| quote!(CONSTANT), |item| quote!(#item))
}

/// Type, length and rights.
fn attributes(entry: &Entry) -> TokenStream {
    let (data_type, bits, access) =
        (data_type(entry.data_type), number(entry.data_type.bits()), access(entry));
    quote!(#data_type, #bits, #access)
}

/// Rights, with the state in which an entry is written that has only one.
fn access(entry: &Entry) -> TokenStream {
    let write = match entry.written.as_deref().and_then(|transition| transition.chars().next()) {
        Some('P') => quote!(PRE_OP),
        Some('S') => quote!(SAFE_OP),
        Some('O') => quote!(OP),
        _ => quote!(WO),
    };
    let rights = match (entry.access, write.to_string() == "WO") {
        (Access::Ro | Access::Const, _) => quote!(RO),
        (Access::Wo, _) => write,
        (Access::Rw, true) => quote!(RW),
        (Access::Rw, false) => quote!(RO.and(#write)),
    };
    match entry.pdo {
        Mappable::None => rights,
        Mappable::Rx => quote!(#rights.and(RX)),
        Mappable::Tx => quote!(#rights.and(TX)),
        Mappable::RxTx => quote!(#rights.and(RX).and(TX)),
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
        // ETG.1020, base data types: BYTE, WORD, DWORD and BIT1 to BIT8
        DataType::Bitstring(8) => "DataType(0x001E)".to_owned(),
        DataType::Bitstring(16) => "DataType(0x001F)".to_owned(),
        DataType::Bitstring(_) => "DataType(0x0020)".to_owned(),
        DataType::Bits(bits) => format!("DataType(0x{:04X})", 0x2F + u16::from(bits)),
    };
    parsed(&name)
}
