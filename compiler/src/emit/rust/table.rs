//! The table that finds an entry by its address, as constant data.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::literal::{hex8, number, parsed};
use super::scope::Scope;
use crate::model::{Access, DataType, Entry, Kind, Mappable, Object};

/// Objects whose indices share the high byte.
struct Page<'a> {
    high: u8,
    objects: Vec<&'a Object>,
}

impl Page<'_> {
    fn lows(&self) -> impl Iterator<Item = u8> {
        self.objects.iter().map(|object| object.index.0.to_be_bytes()[1])
    }

    fn entries(&self) -> usize {
        self.objects.iter().map(|object| object.entries.len()).sum()
    }

    /// The table of objects, which says nothing of the high byte: pages of axes that are alike have the same.
    fn table(&self) -> TokenStream {
        let mut ordinal = 0;
        let objects = self.objects.iter().map(|one| {
            let object = object(one, ordinal);
            ordinal += one.entries.len();
            object
        });
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

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    let pages = pages(&scope.device.objects);
    let mut shared: Vec<(String, Ident)> = Vec::new();
    let (mut tables, mut rows, mut ordinal) = (TokenStream::new(), Vec::new(), 0);
    for page in &pages {
        let table = page.table();
        let slots = page.slots();
        let key = format!("{table}{slots}");
        let known = shared.iter().find(|(known, _)| *known == key).map(|(_, name)| name.clone());
        let name = known.unwrap_or_else(|| {
            let name = format_ident!("PAGE_{:02X}", page.high);
            tables.extend(page_const(&name, page, &table, &slots));
            shared.push((key, name.clone()));
            name
        });
        let ordinal_here = number(ordinal);
        rows.push(quote!(Page { ordinal: #ordinal_here, ..#name }));
        ordinal += page.entries();
    }
    let highs = pages.iter().map(|page| hex8(page.high));
    let (runtime, shorthands) = (scope.runtime, shorthands());
    quote! {
        /// Every entry of the device, to be found by its address.
        pub static TABLE: #runtime::sdo::Dictionary = #runtime::sdo::Dictionary {
            directory: &DIRECTORY,
            pages: &[#(#rows),*],
        };

        const DIRECTORY: [u8; 256] = positions(0, &[#(#highs),*]);
        #shorthands
        #tables
    }
}

fn pages(objects: &[Object]) -> Vec<Page<'_>> {
    let mut pages: Vec<Page<'_>> = Vec::new();
    for object in objects {
        let [high, _] = object.index.0.to_be_bytes();
        match pages.last_mut().filter(|page| page.high == high) {
            Some(page) => page.objects.push(object),
            None => pages.push(Page { high, objects: vec![object] }),
        }
    }
    pages
}

fn page_const(name: &Ident, page: &Page<'_>, table: &TokenStream, slots: &TokenStream) -> TokenStream {
    let (first, slots_name) = (hex8(page.first()), format_ident!("SLOTS_{:02X}", page.high));
    quote! {
        const #slots_name: #slots;

        const #name: Page = Page { first: #first, slots: &#slots_name, objects: &#table, ordinal: 0 };
    }
}

/// What makes a line of each object and entry.
fn shorthands() -> TokenStream {
    quote! {
        const fn object(code: ObjectCode, ordinal: u16, entries: &'static [EntryInfo]) -> ObjectInfo {
            ObjectInfo { code, entries, ordinal }
        }

        const fn entry(subindex: u8, data_type: DataType, bits: u16, access: Access) -> EntryInfo {
            EntryInfo { subindex, data_type, bits, access }
        }

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

fn object(object: &Object, ordinal: usize) -> TokenStream {
    let code = match object.kind {
        Kind::Var => quote!(ObjectCode::Variable),
        Kind::Array => quote!(ObjectCode::Array),
        Kind::Record => quote!(ObjectCode::Record),
    };
    let ordinal = number(ordinal);
    if let Some(list) = list(object) {
        return quote!(object(#code, #ordinal, &const { #list }));
    }
    let entries = object.entries.iter().map(entry);
    quote!(object(#code, #ordinal, &[#(#entries),*]))
}

/// The entries of an object that has a number of entries, read only, and after that entries all alike.
fn list(object: &Object) -> Option<TokenStream> {
    let (count, items) = object.entries.split_first()?;
    let first = items.first()?;
    let is_count = count.data_type == DataType::Uint(8) && access(count).to_string() == "RO";
    let in_a_row =
        object.entries.iter().zip(0..=u8::MAX).all(|(entry, subindex)| entry.address.subindex == subindex);
    let alike = items.iter().all(|item| attributes(item).to_string() == attributes(first).to_string());
    let (length, attributes) = (number(object.entries.len()), attributes(first));
    (is_count && in_a_row && alike).then(|| quote!(EntryInfo::list::<#length>(#attributes)))
}

fn entry(entry: &Entry) -> TokenStream {
    let (subindex, attributes) = (number(entry.address.subindex), attributes(entry));
    quote!(entry(#subindex, #attributes))
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
