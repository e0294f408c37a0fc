//! Units as scales.

use proc_macro2::TokenStream;
use quote::quote;

use super::doc::{Doc, escape};
use super::entry;
use super::literal::grouped;
use super::names::{Names, shout, snake};
use super::scope::Scope;
use crate::model::{AxisUnit, Path, Unit};

pub(super) fn module(scope: &Scope<'_>) -> TokenStream {
    let mut names = Names::default();
    let scales: Vec<TokenStream> =
        scope.device.units.iter().filter_map(|unit| scale(scope, unit, &mut names)).collect();
    if scales.is_empty() {
        return TokenStream::new();
    }
    quote! {
        /// What raw values mean.
        pub mod units {
            use super::*;
            #(#scales)*
        }
    }
}

/// One scale, or one for each axis where they differ; none where the numbers are beyond those of a scale.
fn scale(scope: &Scope<'_>, unit: &Unit, names: &mut Names) -> Option<TokenStream> {
    let scales = unit.axes.iter().map(of_axis).collect::<Option<Vec<_>>>()?;
    let doc = doc(scope, unit);
    let first = scales.first()?;
    if scales.iter().all(|scale| scale.to_string() == first.to_string()) || !scope.has_axes() {
        let name = names.claim(&shout(&unit.id));
        return Some(quote!(#doc pub const #name: Scale = #first;));
    }
    let name = names.claim(&snake(&unit.id));
    let arms =
        scope.axis_idents().into_iter().zip(&scales).map(|((axis, _), scale)| quote!(Axis::#axis => #scale,));
    Some(quote! {
        #doc
        pub const fn #name(axis: Axis) -> Scale {
            match axis { #(#arms)* }
        }
    })
}

fn of_axis(unit: &AxisUnit) -> Option<TokenStream> {
    let (units, raw) = unit.scale.map_or((1, 1), |scale| (scale.units, scale.raw));
    let (units, raw) = (u32::try_from(units).ok()?, u32::try_from(raw).ok()?);
    let (units, raw) = (grouped(units), grouped(raw));
    Some(quote!(Scale::of::<#units, #raw>()))
}

fn doc(scope: &Scope<'_>, unit: &Unit) -> Doc {
    let path = match unit.path {
        Some(Path::Pdo) => " in process data",
        Some(Path::Sdo) => " in SDOs",
        None => "",
    };
    let title = super::doc::sentence(&unit.quantity).trim_end_matches('.').to_owned();
    let factor = unit.factor.map(|address| format!("The device holds the factor in {address}."));
    Doc::new(format!("{title}{path}, {}.", escape(&entry::unit(unit))))
        .maybe(unit.about.as_deref())
        .maybe(factor.as_deref())
        .source(unit.source.as_ref(), scope.device)
}
