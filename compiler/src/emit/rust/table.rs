//! The table that finds an entry by its address, as constant data.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::information;
use super::literal::{hex8, number};
use super::page::{Page, pages};
use super::rows::{self, Row};
use super::scope::Scope;
use super::stored::{Stored, homes};

/// What is on a page, which says nothing of the high byte: pages of axes that are alike have the same.
#[derive(PartialEq)]
struct Layout {
    /// The low bytes of the indices.
    lows: Vec<u8>,
    rows: Vec<Row>,
}

pub(super) fn items(scope: &Scope<'_>, stored: &[Stored<'_>]) -> TokenStream {
    let homes = homes(stored);
    let pages = pages(&scope.device.objects, &homes);
    let mut shared: Vec<(Layout, Ident)> = Vec::new();
    let (mut tables, mut rows) = (TokenStream::new(), Vec::new());
    let mut constants = Constants::default();
    for page in &pages {
        let layout = Layout::of(page, &mut constants);
        let known = shared.iter().find(|(known, _)| *known == layout).map(|(_, name)| name.clone());
        let name = known.unwrap_or_else(|| {
            let name = format_ident!("PAGE_{:02X}", page.high);
            tables.extend(layout.tokens(page.high, &name));
            shared.push((layout, name.clone()));
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

impl Layout {
    fn of(page: &Page<'_>, constants: &mut Constants) -> Self {
        let axis = page.axis();
        let rows = page.rows.iter().map(|(object, home)| {
            let constants = constants.position(rows::constants(object, *home));
            Row::new(object, *home, axis, constants)
        });
        let lows = page.objects().map(|object| object.index.0.to_be_bytes()[1]).collect();
        Self { rows: rows.collect(), lows }
    }

    /// The constants of a page, first of the positions of its objects, from the first low byte to the last.
    fn tokens(&self, high: u8, name: &Ident) -> TokenStream {
        let (first, last) = (self.lows.first().copied().unwrap_or(0), self.lows.last().copied().unwrap_or(0));
        let length = number(u16::from(last).saturating_sub(first.into()).saturating_add(1));
        let (first, lows) = (hex8(first), self.lows.iter().copied().map(hex8));
        let (slots, objects) = (format_ident!("SLOTS_{high:02X}"), self.rows.iter().map(Row::tokens));
        quote! {
            const #slots: [u8; #length] = positions(#first, &[#(#lows),*]);

            const #name: Page = Page { first: #first, axis: 0, slots: &#slots, objects: &[#(#objects),*] };
        }
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
