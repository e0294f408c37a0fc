//! A struct for each PDO, or for the PDOs of all axes that are alike.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::axes::{self, Placed};
use super::bytes::Place;
use super::doc::{Doc, escape};
use super::entry;
use super::item::{Holders, Item, Space};
use super::literal::number;
use super::names::{Names, snake};
use super::packing::{self, Layout};
use super::scope::Scope;
use super::types::{Primitive, ValueType};
use crate::model::{DataType, Direction, Entry, Mapped, Pdo};

/// Who maps a PDO.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum By {
    /// The device, as it starts.
    Device,
    /// A master, as a configuration has it.
    Master,
}

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    let items = scope.pdos.iter().map(|pdo| {
        let name = scope.pdo_ident(pdo);
        let item = Item::held(name.clone(), move |holders| code(scope, pdo, By::Device, holders));
        made_of(scope, pdo, item.with_name(format_ident!("{name}View")))
    });
    items.collect()
}

/// What the struct of a PDO depends on.
pub(super) fn made_of<'s>(scope: &'s Scope<'_>, placed: &Placed<'s, Pdo>, item: Item<'s>) -> Item<'s> {
    let item = item.each(&placed.all, |item, pdo| item.of(*pdo));
    let mapped = placed.first.entries.iter().filter_map(|mapped| Some((mapped, mapped.address?)));
    let item = item.each(mapped, |item, (mapped, address)| {
        let value = value_type(scope, mapped);
        let entry = scope.device.entry(address);
        let carried = entry.map(|entry| carried(mapped, entry));
        let item = item.told(format!("{:?} {carried:?}", value.primitive));
        let item = item.each(&value.newtype, |item, name| item.using(Space::Root, name));
        let unit = entry.and_then(|entry| scope.device.unit(entry.unit.as_ref()?));
        item.each(unit.filter(|unit| !scope.unlike.contains(unit.id.as_str())), |item, unit| item.of(unit))
    });
    match placed.shift {
        Some(_) => scope.placed(item.of(&scope.device.arrangement), placed.shift),
        None => item,
    }
}

/// The constant that says which members of a family have it; nothing if all have.
pub(super) fn members(holders: &Holders<'_>) -> Option<TokenStream> {
    let places = holders.places.iter().copied().map(number);
    (!holders.is_all).then(|| {
        quote!(
            const MEMBERS: Members = Members::of(&[#(#places),*]);
        )
    })
}

pub(super) fn code(
    scope: &Scope<'_>,
    placed: &Placed<'_, Pdo>,
    by: By,
    holders: &Holders<'_>,
) -> (Doc, TokenStream) {
    let pdo = placed.first;
    let (name, places) = (scope.pdo_ident(placed), places(scope, pdo));
    let fields = pdo.entries.iter().zip(&places).filter_map(|(mapped, place)| field(scope, mapped, place));
    let doc = doc(scope, placed);
    let layout = Layout::of_fields(&places, pdo.bytes());
    let packing = packing::items(scope, &name, direction(pdo.direction), &layout);
    let mapping = mapping(scope, placed, &name, by, holders);
    let code = quote! {
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #name { #(#fields)* }

        #packing
        #mapping
    };
    (doc, code)
}

/// The type of a direction.
pub(super) fn direction(direction: Direction) -> TokenStream {
    match direction {
        Direction::Rx => quote!(Rx),
        Direction::Tx => quote!(Tx),
    }
}

fn doc(scope: &Scope<'_>, placed: &Placed<'_, Pdo>) -> Doc {
    let pdo = placed.first;
    let axes = match (placed.shift, placed.all.last()) {
        (Some(by), Some(last)) => format!(" One for each axis, 0x{by:X} apart, up to `{}`.", last.index),
        _ => String::new(),
    };
    let excludes: Vec<String> = pdo.excludes.iter().map(|index| format!("`{index}`")).collect();
    let excludes = if excludes.is_empty() {
        String::new()
    } else {
        format!("Not together with {}.", excludes.join(", "))
    };
    Doc::new(format!("`{}` {}, {} bytes.{axes}", pdo.index, escape(&pdo.name), pdo.bytes()))
        .maybe(pdo.about.as_deref())
        .text(&excludes)
        .said(pdo.source.as_ref(), &pdo.origin, scope.device)
}

/// The fields with their bits; padding has none of a name.
fn places(scope: &Scope<'_>, pdo: &Pdo) -> Vec<Place> {
    let mut names = Names::default();
    let place = |mapped: &Mapped| Place {
        name: mapped.address.map(|_| names.claim(&snake(&mapped.id))),
        value: value_type(scope, mapped),
        offset: mapped.offset,
        bits: mapped.bits,
    };
    pdo.entries.iter().map(place).collect()
}

/// The type of the entry, or the one that its bits ask for if the entry is not in the dictionary.
fn value_type(scope: &Scope<'_>, mapped: &Mapped) -> ValueType {
    let bare = |primitive| ValueType { primitive, newtype: None };
    match mapped.data_type {
        Some(DataType::Text(length)) => bare(Primitive::Bytes(length.into())),
        Some(data_type) => scope.types.at(mapped.address, data_type),
        None => bare(Primitive::of_bits(mapped.bits)),
    }
}

fn field(scope: &Scope<'_>, mapped: &Mapped, place: &Place) -> Option<TokenStream> {
    let (name, value, address) = (place.name.as_ref()?, place.value.field(), mapped.address?);
    let title = format!("`{address}` {}", super::doc::sentence(&mapped.name));
    let doc = match scope.device.entry(address) {
        Some(entry) => {
            let unit = entry.unit.as_ref().and_then(|id| scope.device.unit(id));
            let unit = unit.map(|unit| match scope.unlike.contains(unit.id.as_str()) {
                true => "in the unit that the device has for it".to_owned(),
                false => entry::unit(unit),
            });
            let title = match unit {
                Some(unit) => format!("{}, {}.", title.trim_end_matches('.'), escape(&unit)),
                None => title,
            };
            Doc::new(title).text(&carried(mapped, entry))
        }
        None if mapped.data_type.is_some() => Doc::new(title).text("The dictionary does not have it."),
        None => Doc::new(title).text("The dictionary does not have it, so only its width is known."),
    };
    Some(quote!(#doc pub #name: #value,))
}

/// How the PDO carries an object, where that is not the object's own type.
fn carried(mapped: &Mapped, entry: &Entry) -> String {
    let (object, own, bits) = (entry.data_type, entry.data_type.bits(), mapped.bits);
    match mapped.own_type.filter(|own| *own != object) {
        Some(carried) => format!("The object is {object}, the PDO carries it as {carried}."),
        None if bits < own => {
            format!("The object is {object}, the PDO carries the lower {bits} of its {own} bits.")
        }
        None if bits > own => format!("The object is {object}, the PDO has {bits} bits for its {own}."),
        None => String::new(),
    }
}

/// The index and what is mapped: of the PDO, or of each axis and for the trait of the first.
fn mapping(
    scope: &Scope<'_>,
    placed: &Placed<'_, Pdo>,
    name: &Ident,
    by: By,
    holders: &Holders<'_>,
) -> TokenStream {
    let (pdo, rows) = (placed.first, rows(scope, placed));
    let (count, index) = (number(pdo.entries.len()), axes::index(pdo.index, placed.shift));
    let members = members(holders);
    let made = match by {
        By::Device => quote!(MappedPdo::new),
        By::Master => quote!(MappedPdo::own),
    };
    if placed.shift.is_none() {
        let all = (by == By::Master).then(|| {
            quote!(
                const ALL: &'static [MappedPdo] = &[#made(Self::INDEX, Self::MAPPING)];
            )
        });
        return quote! {
            impl Pdo for #name {
                const INDEX: u16 = #index;
                const MAPPING: &'static [Mapping] = &[#(#rows),*];
                #all
                #members
            }
        };
    }
    let axes: Vec<Ident> = scope.axis_idents().into_iter().map(|(axis, _)| axis).collect();
    let first = axes.first();
    let all = axes.iter().map(|axis| quote!(#made(Self::index(Axis::#axis), &Self::mapping(Axis::#axis))));
    quote! {
        impl #name {
            /// The index of the PDO of an axis.
            pub const fn index(axis: Axis) -> u16 {
                #index
            }

            /// What is mapped on an axis.
            pub const fn mapping(axis: Axis) -> [Mapping; #count] {
                [#(#rows),*]
            }
        }

        impl Pdo for #name {
            const INDEX: u16 = Self::index(Axis::#first);
            const MAPPING: &'static [Mapping] = &Self::mapping(Axis::#first);
            const ALL: &'static [MappedPdo] = &[#(#all),*];
            #members
        }
    }
}

/// What is mapped, of an axis if each has the PDO.
fn rows(scope: &Scope<'_>, placed: &Placed<'_, Pdo>) -> Vec<TokenStream> {
    let rows = placed.first.entries.iter().map(|mapped| {
        let (index, subindex) = match mapped.address {
            Some(address) => {
                let shift = placed.shift.and_then(|_| axes::shift(scope.device, address.index));
                (axes::index(address.index, shift), number(address.subindex))
            }
            None => (quote!(0), number(0)),
        };
        let bits = number(mapped.bits);
        quote!(Mapping { address: Address::new(#index, #subindex), bits: #bits })
    });
    rows.collect()
}
