//! What a server asks of a dictionary besides its values.

use proc_macro2::TokenStream;
use quote::quote;

use super::doc::Doc;
use super::literal::{hex16, number};
use super::ranges;
use super::scope::Scope;
use super::stored::Stored;

pub(super) fn items(scope: &Scope<'_>, stored: &[Stored<'_>]) -> TokenStream {
    let (constant, ranges) = ranges::items(scope, stored);
    let mailbox = scope.device.mailbox.as_ref().filter(|mailbox| mailbox.complete_access);
    let complete_access = mailbox.map(|mailbox| {
        let doc = Doc::default().departing(&["complete-access"], &mailbox.origin, scope.device);
        quote!(
            #doc
            #[inline]
            fn has_complete_access(&self) -> bool {
                true
            }
        )
    });
    let process_data = process_data(scope);
    quote! {
        impl sdo::Values for Dictionary {
            #[inline]
            fn table(&self) -> &'static sdo::Dictionary {
                &TABLE
            }

            #constant
            #complete_access
            #process_data

            fn slot(&mut self, place: sdo::Place) -> Option<sdo::Slot<'_>> {
                self.field(place)
            }
        }
        #ranges
    }
}

/// What process data may be made of, for a device that has any.
fn process_data(scope: &Scope<'_>) -> Option<TokenStream> {
    let device = scope.device;
    let limits = device.pdos.iter().filter_map(|pdo| Some((hex16(pdo.index.0), number(pdo.max_bytes?))));
    let limits = limits.map(|(index, bytes)| quote!((#index, #bytes)));
    (!device.pdos.is_empty()).then(|| {
        quote! {
            #[inline]
            fn process_data(&self) -> Option<&'static sdo::PdoRules> {
                Some(&const {
                    sdo::PdoRules { outputs: BRING_UP.outputs, inputs: BRING_UP.inputs, max_bytes: &[#(#limits),*] }
                })
            }
        }
    })
}
