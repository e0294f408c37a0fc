//! Units as types of what they measure, or as bare scales where they count something of the device's own.

use proc_macro2::TokenStream;
use quote::quote;

use super::axes::Placed;
use super::doc::{Doc, escape, sentence};
use super::literal::grouped;
use super::measure::Means;
use super::measured::{Constant, Measured};
use super::names::camel;
use super::scope::Scope;
use super::types::ValueType;
use crate::model::{AxisUnit, Entry, Object, Path, Unit};

pub(super) fn module(scope: &Scope<'_>) -> TokenStream {
    if scope.units.is_empty() {
        return TokenStream::new();
    }
    let units = scope.units.iter().map(|measured| items(scope, measured));
    quote! {
        /// What raw values mean, and how to come from physical values to raw ones.
        pub mod units {
            use super::*;
            #(#units)*
        }
    }
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
fn items(scope: &Scope<'_>, measured: &Measured<'_>) -> TokenStream {
    let is_one = measured.constants.len() == 1;
    let constants = measured.constants.iter().map(|constant| {
        let step = format!("a step is {}", escape(&step(constant.first)));
        let of_axes = if is_one { String::new() } else { format!(" of {}", axes(scope, constant)) };
        let doc = doc(scope, measured.unit, &of_axes, &step);
        let (name, ty, value) = (&constant.name, constant.means.unit(&scope.marker), value(constant));
        quote!(#doc pub const #name: #ty = #value;)
    });
    let function = function(scope, measured);
    quote!(#(#constants)* #function)
}

/// The function of the axis, where axes differ.
fn function(scope: &Scope<'_>, measured: &Measured<'_>) -> Option<TokenStream> {
    let (name, means) = measured.of_axis.as_ref()?;
    let steps = measured
        .constants
        .iter()
        .map(|constant| format!("{} on {}", escape(&step(constant.first)), axes(scope, constant)));
    let steps = format!("a step is {}", steps.collect::<Vec<_>>().join(", "));
    let (doc, ty) = (doc(scope, measured.unit, " of an axis", &steps), means.unit(&scope.marker));
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
    Some(quote! {
        #doc
        pub const fn #name(axis: Axis) -> #ty {
            match axis { #(#arms)* }
        }
    })
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
