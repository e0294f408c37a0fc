//! What a device lets a master assign: the rules that process images are held against when code is compiled.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::doc::Doc;
use super::literal::{hex16, number, option};
use super::scope::Scope;
use crate::model::{Carried, Direction, Index, Role};

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    [Direction::Rx, Direction::Tx].into_iter().filter_map(|way| item(scope, way)).collect()
}

/// What the sync managers of a direction carry together.
fn item(scope: &Scope<'_>, way: Direction) -> Option<TokenStream> {
    let first = scope.device.sync_manager(Role::of(way))?;
    let Carried { default, assignable, slots, max_size, mandatory, exclusive } = scope.device.carried(way)?;
    let (marker, direction) = (&scope.marker, super::pdos::direction(way));
    let (default, mandatory) = (default.iter().map(hex), mandatory.iter().map(hex));
    let (slots, max_size) = (number(slots), option(max_size.map(number)));
    let pairs = exclusive.iter().map(|pair| {
        let pair = pair.iter().map(hex);
        quote!([#(#pair),*])
    });
    let doc = Doc::default().said(first.source.as_ref(), &first.origin, scope.device);
    Some(quote! {
        #doc
        impl Carries<#direction> for #marker {
            const SYNC_MANAGER: SyncManager = SyncManager {
                default: &[#(#default),*],
                assignable: #assignable,
                slots: #slots,
                max_size: #max_size,
                mandatory: &[#(#mandatory),*],
                exclusive: &[#(#pairs),*],
            };
        }
    })
}

fn hex(index: &Index) -> Literal {
    hex16(index.0)
}
