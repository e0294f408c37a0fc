//! What a device lets a master assign: the rules that process images are held against when code is compiled.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::doc::Doc;
use super::literal::{hex16, number, option};
use super::scope::Scope;
use crate::model::{Direction, Index, Role, SyncManager};

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    let ways = [(Role::Outputs, Direction::Rx), (Role::Inputs, Direction::Tx)];
    let managers = ways.into_iter().filter_map(|(role, way)| {
        let managers: Vec<&SyncManager> = scope.device.sync_managers_of(role).collect();
        let first = managers.first()?;
        Some(item(scope, first, &managers, way))
    });
    managers.collect()
}

/// What the sync managers of a direction carry together.
fn item(scope: &Scope<'_>, first: &SyncManager, managers: &[&SyncManager], way: Direction) -> TokenStream {
    let (marker, direction) = (&scope.marker, super::pdos::direction(way));
    let default = managers.iter().flat_map(|manager| &manager.pdos).map(hex);
    let assignable = scope.device.mailbox.as_ref().is_none_or(|mailbox| mailbox.pdo_assign);
    let slots = number(managers.iter().fold(0_u8, |sum, manager| sum.saturating_add(manager.slots)));
    let max_size =
        managers.iter().try_fold(0_u16, |sum, manager| Some(sum.saturating_add(manager.max_size?)));
    let max_size = option(max_size.map(number));
    let of_way = || scope.device.pdos.iter().filter(move |pdo| pdo.direction == way);
    let mandatory = of_way().filter(|pdo| pdo.mandatory).map(|pdo| hex(&pdo.index));
    let pairs: BTreeSet<(Index, Index)> = of_way()
        .flat_map(|pdo| pdo.excludes.iter().map(|other| (pdo.index.min(*other), pdo.index.max(*other))))
        .collect();
    let pairs = pairs.iter().map(|(one, other)| {
        let (one, other) = (hex(one), hex(other));
        quote!([#one, #other])
    });
    let doc = Doc::default().said(first.source.as_ref(), &first.origin, scope.device);
    quote! {
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
    }
}

fn hex(index: &Index) -> Literal {
    hex16(index.0)
}
