//! The table that finds an entry by its address, as constant data.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::doc::Doc;
use super::information;
use super::item::{Item, Reach, Space};
use super::literal::{hex8, number};
use super::page::{Page, pages};
use super::rows::{self, Lists, Row};
use super::scope::Scope;
use super::stored::{Stored, homes};

/// What is on a page, which says nothing of the high byte: pages of axes that are alike have the same.
#[derive(Debug, PartialEq)]
struct Layout {
    /// The low bytes of the indices.
    lows: Vec<u8>,
    rows: Vec<Row>,
}

pub(super) fn items<'s>(scope: &'s Scope<'_>, stored: &[Stored<'s>]) -> Vec<Item<'s>> {
    let homes = homes(stored);
    let pages = pages(&scope.device.objects, &homes);
    let mut shared: Vec<(Layout, Ident)> = Vec::new();
    let (mut rows, mut items) = (Vec::new(), Vec::new());
    let (mut constants, mut lists) = (Constants::default(), Lists::default());
    for page in &pages {
        let layout = Layout::of(page, &mut constants);
        let known = shared.iter().find(|(known, _)| *known == layout).map(|(_, name)| name.clone());
        let name = known.unwrap_or_else(|| {
            let name = format_ident!("PAGE_{:02X}", page.high);
            items.push(layout.item(scope, page, &name, &mut lists));
            shared.push((layout, name.clone()));
            name
        });
        rows.push(match page.axis() {
            0 => quote!(#name),
            axis => {
                let axis = number(axis);
                quote!(Page { axis: #axis, ..#name })
            }
        });
    }
    let highs: Vec<Literal> = pages.iter().map(|page| hex8(page.high)).collect();
    let table = Item::new(format_ident!("TABLE"), move || table(&rows, &highs, &constants));
    let lists = lists.items(scope);
    let information = scope.device.mailbox.as_ref().filter(|mailbox| mailbox.sdo_info);
    let names = information.map(|_| information::items(scope, &pages));
    let table = [table.reaching(Reach::Own)].into_iter().chain(lists).chain(items);
    table.chain(names.into_iter().flatten()).collect()
}

fn table(rows: &[TokenStream], highs: &[Literal], constants: &Constants) -> (Doc, TokenStream) {
    let constants = constants.tokens();
    let code = quote! {
        pub static TABLE: sdo::Dictionary = sdo::Dictionary {
            directory: &DIRECTORY,
            pages: &[#(#rows),*],
            constants: &CONSTANTS,
        };

        const DIRECTORY: [u8; 256] = positions(0, &[#(#highs),*]);
        #constants
    };
    (Doc::new("Every entry of the device, to be found by its address."), code)
}

impl Layout {
    fn of(page: &Page<'_, '_>, constants: &mut Constants) -> Self {
        let axis = page.axis();
        let rows = page.rows.iter().map(|(object, home)| {
            let constants = constants.position(rows::constants(object, *home));
            Row::new(object, *home, axis, constants)
        });
        let lows = page.objects().map(|object| object.index.0.to_be_bytes()[1]).collect();
        Self { rows: rows.collect(), lows }
    }

    /// The constants of a page, first of the positions of its objects, from the first low byte to the last.
    fn item<'s>(&self, scope: &Scope<'_>, page: &Page<'s, '_>, name: &Ident, lists: &mut Lists) -> Item<'s> {
        let (high, within) = (page.high, &scope.within.0);
        let (first, last) = (self.lows.first().copied().unwrap_or(0), self.lows.last().copied().unwrap_or(0));
        let length = number(u16::from(last).saturating_sub(first.into()).saturating_add(1));
        let (first, lows) = (hex8(first), self.lows.iter().copied().map(hex8));
        let slots = format_ident!("SLOTS_{high:02X}");
        let (objects, named): (Vec<TokenStream>, Vec<Option<Ident>>) =
            self.rows.iter().zip(page.objects()).map(|(row, object)| row.tokens(object, lists)).unzip();
        let code = quote! {
            #within const #slots: [u8; #length] = positions(#first, &[#(#lows),*]);

            #within const #name: Page =
                Page { first: #first, axis: 0, slots: &#slots, objects: &[#(#objects),*] };
        };
        let item = Item::new(name.clone(), move || (Doc::default(), code.clone()));
        let item = item.with_name(slots).reaching(Reach::Family).told(format!("{self:?}"));
        item.each(named.into_iter().flatten(), |item, name| item.using(Space::Dictionary, &name))
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
