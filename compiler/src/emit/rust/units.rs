//! Units as types of what they measure, or as bare scales where they count something of the device's own.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::axes::Placed;
use super::doc::{Doc, escape, sentence};
use super::item::{Item, Space};
use super::literal::grouped;
use super::measure::Means;
use super::measured::{Constant, Measured};
use super::names::camel;
use super::scope::Scope;
use super::types::ValueType;
use crate::model::{AxisUnit, Entry, Object, Path, Unit};

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    scope.units.iter().flat_map(|measured| items_of(scope, measured)).collect()
}

/// The item with the unit of an entry, and the items that its constant may name.
pub(super) fn named<'s>(scope: &'s Scope<'_>, entry: &Entry, item: Item<'s>) -> Item<'s> {
    let unit = entry.unit.as_ref().and_then(|id| scope.device.unit(id));
    let measured = unit.and_then(|unit| scope.units.iter().find(|measured| measured.unit.id == unit.id));
    let names = measured.into_iter().flat_map(Measured::names);
    item.each(unit, |item, unit| item.of(unit)).each(names, |item, name| item.using(Space::Units, name))
}

/// What an entry measures, and the place of its unit; none if its value is no number or in another unit on another axis.
pub(super) fn of_entry(
    scope: &Scope<'_>,
    placed: &Placed<'_, Object>,
    entry: &Entry,
) -> Option<(TokenStream, TokenStream)> {
    let id = entry.unit.as_ref()?;
    let ValueType { primitive, newtype } = scope.types.at(Some(entry.address), entry.data_type);
    let is_number = primitive.is_number() && newtype.is_none();
    let of_axes = placed.all.iter().map(|object| object.entry(entry.address.subindex));
    let is_same = of_axes.flatten().all(|other| other.unit.as_ref() == Some(id));
    let measured = scope.units.iter().find(|measured| measured.unit.id == *id)?;
    let (means, place) = measured.at(placed)?;
    (is_number && is_same).then(|| (means.measurand(), place))
}

/// A constant for all axes that measure the same: none of them can be taken for an axis that measures something else.
/// And where axes differ, what each of them has.
fn items_of<'s>(scope: &'s Scope<'_>, measured: &'s Measured<'_>) -> Vec<Item<'s>> {
    let is_one = measured.constants.len() == 1;
    let with_axes = |item: Item<'s>| if is_one { item } else { item.of(&scope.device.axes) };
    let constants = measured.constants.iter().map(|constant| {
        let item = Item::new(constant.name.clone(), move || {
            let step = format!("a step is {}", escape(&step(constant.first)));
            let of_axes = if is_one { String::new() } else { format!(" of {}", axes(scope, constant)) };
            let doc = doc(scope, measured.unit, &of_axes, &step);
            let (name, ty, value) = (&constant.name, constant.means.unit(&scope.owner), value(constant));
            (doc, quote!(pub const #name: #ty = #value;))
        });
        with_axes(item.of(measured.unit))
    });
    let function = measured.of_axis.as_ref().map(|(name, means)| {
        let item = Item::new(name.clone(), move || function(scope, measured, name, *means));
        scope.placed(with_axes(item.of(measured.unit)), Some(0))
    });
    constants.chain(function).collect()
}

/// The function of the axis, where axes differ.
fn function(scope: &Scope<'_>, measured: &Measured<'_>, name: &Ident, means: Means) -> (Doc, TokenStream) {
    let steps = measured
        .constants
        .iter()
        .map(|constant| format!("{} on {}", escape(&step(constant.first)), axes(scope, constant)));
    let steps = format!("a step is {}", steps.collect::<Vec<_>>().join(", "));
    let (doc, ty) = (doc(scope, measured.unit, " of an axis", &steps), means.unit(&scope.owner));
    let idents = scope.axis_idents();
    let arms = measured.constants.iter().map(|constant| {
        let axes = constant.axes.iter().filter_map(|axis| idents.get(*axis)).map(|(axis, _)| axis);
        let unit = &constant.name;
        let unit = match (means, constant.means.is_rotary()) {
            (Means::Motion(..), true) => quote!(Motion::Rotary(#unit)),
            (Means::Motion(..), false) => quote!(Motion::Linear(#unit)),
            _ => quote!(#unit),
        };
        quote!(#(Axis::#axes)|* => #unit,)
    });
    let code = quote! {
        pub const fn #name(axis: Axis) -> #ty {
            match axis { #(#arms)* }
        }
    };
    (doc, code)
}

fn value(constant: &Constant<'_>) -> TokenStream {
    let (smallest, raw) = (grouped(constant.scale.units), grouped(constant.scale.raw));
    let ty = camel(if constant.means == Means::Own { "Scale" } else { "Unit" });
    quote!(#ty::of::<#smallest, #raw>())
}

fn doc(scope: &Scope<'_>, unit: &Unit, of_axes: &str, steps: &str) -> Doc {
    let path = match unit.path {
        Some(Path::Pdo) => " in process data",
        Some(Path::Sdo) => " in SDOs",
        None => "",
    };
    let title = sentence(&unit.quantity).trim_end_matches('.').to_owned();
    let factor = unit.factor.map(|address| format!("The device holds the factor in {address}."));
    Doc::new(format!("{title}{path}{of_axes}: {steps}."))
        .maybe(unit.about.as_deref())
        .maybe(factor.as_deref())
        .said(unit.source.as_ref(), &unit.origin, scope.device)
}

/// The names of the axes.
fn axes(scope: &Scope<'_>, constant: &Constant<'_>) -> String {
    let axes = constant.axes.iter().filter_map(|axis| scope.device.axes.get(*axis));
    axes.map(|axis| axis.name.as_str()).collect::<Vec<_>>().join(", ")
}

/// A raw step in the unit.
fn step(unit: &AxisUnit) -> String {
    let symbol = &unit.symbol;
    match unit.scale {
        Some(scale) if scale.raw == 1 => format!("{} {symbol}", scale.units),
        Some(scale) => format!("{}/{} {symbol}", scale.units, scale.raw),
        None => format!("1 {symbol}"),
    }
}
