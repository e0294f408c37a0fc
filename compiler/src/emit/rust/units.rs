//! Units as types of what they measure, or as bare scales where they count something of the device's own.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::doc::{Doc, escape, sentence};
use super::literal::grouped;
use super::measure::Measure;
use super::names::{Names, camel, shout, snake};
use super::scope::Scope;
use crate::model::{AxisUnit, Path, Scale, Unit};

pub(super) fn module(scope: &Scope<'_>) -> TokenStream {
    let mut names = Names::default();
    let units: TokenStream =
        scope.device.units.iter().flat_map(|unit| items(scope, unit, &mut names)).collect();
    if units.is_empty() {
        return TokenStream::new();
    }
    let (runtime, types) = (scope.runtime, types(scope));
    quote! {
        /// What raw values mean, and how to come from physical values to raw ones.
        pub mod units {
            use super::*;
            use #runtime::unit::{#(#types),*};
            #units
        }
    }
}

/// The runtime's types that the units need, each once, by name.
fn types(scope: &Scope<'_>) -> BTreeSet<Ident> {
    let axes = scope.device.units.iter().flat_map(|unit| &unit.axes);
    let types = axes.flat_map(|unit| match Measure::of(&unit.symbol) {
        Some(measure) => vec![camel("Unit"), measure.quantity()],
        None => vec![camel("Scale")],
    });
    types.collect()
}

/// Axes on which a unit measures the same.
struct Group<'a> {
    axes: Vec<usize>,
    first: &'a AxisUnit,
}

/// One item for all axes that measure the same: none of them can be taken for an axis that measures something else.
fn items(scope: &Scope<'_>, unit: &Unit, names: &mut Names) -> Vec<TokenStream> {
    let mut groups: Vec<Group<'_>> = Vec::new();
    for (axis, first) in unit.axes.iter().enumerate() {
        match groups.iter_mut().find(|group| group.first.symbol == first.symbol) {
            Some(group) => group.axes.push(axis),
            None => groups.push(Group { axes: vec![axis], first }),
        }
    }
    let is_one = groups.len() == 1;
    groups.iter().filter_map(|group| item(scope, unit, group, is_one, names)).collect()
}

/// A constant, or a function of the axis where the scale differs from one to another; none where the numbers are
/// beyond those of a scale.
fn item(
    scope: &Scope<'_>,
    unit: &Unit,
    group: &Group<'_>,
    is_one: bool,
    names: &mut Names,
) -> Option<TokenStream> {
    let scales =
        group.axes.iter().map(|axis| Scaled::of(unit.axes.get(*axis)?)).collect::<Option<Vec<_>>>()?;
    let (first, doc) = (scales.first()?, doc(scope, unit, group, is_one));
    let id = if is_one { unit.id.clone() } else { format!("{}-{}", unit.id, word(&group.first.symbol)) };
    let (name, ty) = (shout(&id), first.ty(&scope.marker));
    if scales.iter().all(|scale| scale == first) {
        let (name, value) = (names.claim(&name), first.tokens());
        return Some(quote!(#doc pub const #name: #ty = #value;));
    }
    let name = names.claim(&snake(&id));
    let axes = scope.axis_idents();
    let arms = group.axes.iter().zip(&scales).filter_map(|(axis, scale)| {
        let ((axis, _), scale) = (axes.get(*axis)?, scale.tokens());
        Some(quote!(Axis::#axis => Some(#scale),))
    });
    let others = (group.axes.len() < axes.len()).then(|| quote!(_ => None,));
    Some(quote! {
        #doc
        ///
        /// None for an axis that has it not.
        pub const fn #name(axis: Axis) -> Option<#ty> {
            match axis { #(#arms)* #others }
        }
    })
}

/// What a unit measures, and raw steps to so many of the smallest unit of that.
#[derive(PartialEq, Eq)]
struct Scaled {
    measure: Option<Measure>,
    scale: Scale,
}

impl Scaled {
    fn of(unit: &AxisUnit) -> Option<Self> {
        let (units, raw) = unit.scale.map_or((1, 1), |scale| (scale.units, scale.raw));
        let measure = Measure::of(&unit.symbol);
        let smallest = measure.map_or(Some(units), |measure| units.checked_mul(measure.smallest))?;
        (smallest > 0 && raw > 0).then(|| Self { measure, scale: Scale::lowest(raw, smallest) })
    }

    /// The type: of the device and of what is measured.
    fn ty(&self, marker: &Ident) -> TokenStream {
        match self.measure.map(Measure::quantity) {
            Some(quantity) => quote!(Unit<#marker, #quantity>),
            None => quote!(Scale),
        }
    }

    fn tokens(&self) -> TokenStream {
        let (smallest, raw) = (grouped(self.scale.units), grouped(self.scale.raw));
        let name = camel(if self.measure.is_some() { "Unit" } else { "Scale" });
        quote!(#name::of::<#smallest, #raw>())
    }
}

/// A word for a symbol, where a unit has several: `mm/s` is `mm-per-s`.
fn word(symbol: &str) -> String {
    symbol.replace('µ', "u").replace('°', "deg").replace('²', "2").replace('/', "-per-")
}

fn doc(scope: &Scope<'_>, unit: &Unit, group: &Group<'_>, is_one: bool) -> Doc {
    let path = match unit.path {
        Some(Path::Pdo) => " in process data",
        Some(Path::Sdo) => " in SDOs",
        None => "",
    };
    let names: Vec<&str> = group
        .axes
        .iter()
        .filter_map(|axis| scope.device.axes.get(*axis).map(|axis| axis.name.as_str()))
        .collect();
    let of_axes = if is_one { String::new() } else { format!(" of {}", names.join(", ")) };
    let title = sentence(&unit.quantity).trim_end_matches('.').to_owned();
    let factor = unit.factor.map(|address| format!("The device holds the factor in {address}."));
    Doc::new(format!("{title}{path}{of_axes}: a step is {}.", escape(&step(group.first))))
        .maybe(unit.about.as_deref())
        .maybe(factor.as_deref())
        .source(unit.source.as_ref(), scope.device)
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
