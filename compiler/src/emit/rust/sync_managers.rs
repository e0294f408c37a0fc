//! What a device lets a master assign: the rules that process images are held against when code is compiled.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::doc::Doc;
use super::literal::{hex16, number, option};
use super::scope::Scope;
use crate::model::{Carried, Direction, Index, Role};

/// What the sync managers of a direction carry together.
pub(super) fn value(scope: &Scope<'_>, way: Direction) -> Option<TokenStream> {
    let Carried { carriers, assignable, slots, max_size, mandatory, exclusive } =
        scope.device.carried(way)?;
    let carriers = carriers.iter().map(|(assignment, pdos)| {
        let (assignment, pdos) = (hex(assignment), pdos.iter().map(hex));
        quote!(Carrier { assignment: #assignment, pdos: &[#(#pdos),*] })
    });
    let mandatory = mandatory.iter().map(hex);
    let (slots, max_size) = (number(slots), option(max_size.map(number)));
    let pairs = exclusive.iter().map(|pair| {
        let pair = pair.iter().map(hex);
        quote!([#(#pair),*])
    });
    Some(quote! {
        SyncManager {
            carriers: &[#(#carriers),*],
            assignable: #assignable,
            slots: #slots,
            max_size: #max_size,
            mandatory: &[#(#mandatory),*],
            exclusive: &[#(#pairs),*],
        }
    })
}

/// Where the facts about the sync manager of a direction are from.
pub(super) fn said(scope: &Scope<'_>, way: Direction, doc: Doc) -> Doc {
    match scope.device.sync_manager(Role::of(way)) {
        Some(manager) => doc.said(manager.source.as_ref(), &manager.origin, scope.device),
        None => doc,
    }
}

fn hex(index: &Index) -> Literal {
    hex16(index.0)
}
