//! The homing methods of 0x6098.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::doc::{Doc, escape, sentence};
use super::item::Item;
use super::literal::{line, number};
use super::names::{Names, shout};
use super::scope::Scope;
use super::types::address;
use crate::model::{Alternative, HomingMethod, Way};

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Option<Item<'s>> {
    let methods = &scope.device.homing_methods;
    let name = scope.types.newtype(address(0x6098)).filter(|_| !methods.is_empty())?;
    Some(Item::new(name.clone(), move || code(scope, methods, name)).of(methods))
}

fn code(scope: &Scope<'_>, methods: &[HomingMethod], name: &Ident) -> (Doc, TokenStream) {
    let mut names = Names::default();
    let constants = methods.iter().map(|method| {
        let (doc, number) = (doc(scope, method), number(method.number));
        let constant = names.claim(&shout(&method.id));
        quote!(#doc pub const #constant: Self = Self(#number);)
    });
    let (rows, runtime) = (rows(methods), scope.runtime);
    let doc = "`0x6098` A homing method. Numbers that the description does not name stay what they are.";
    let code = quote! {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct #name(pub i8);

        impl #name { #(#constants)* }

        impl #runtime::cia402::HomingMethod for #name {
            const TABLE: &'static [#runtime::cia402::HomingInfo] = {
                use #runtime::cia402::{Direction, HomingInfo};
                &[#(#rows),*]
            };
            fn number(self) -> i8 {
                self.0
            }
        }

        impl core::fmt::Display for #name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                #runtime::cia402::homing_method(*self).fmt(f)
            }
        }

        #runtime::value!(#name as i8);
    };
    (Doc::new(doc), code)
}

/// A row for each number that selects a method, by number.
fn rows(methods: &[HomingMethod]) -> Vec<TokenStream> {
    let numbers = methods.iter().flat_map(|method| {
        std::iter::once(method.number)
            .chain(method.aliases.iter().copied())
            .map(move |number| (number, method))
    });
    let mut numbers: Vec<(i8, &HomingMethod)> = numbers.collect();
    numbers.sort_by_key(|(number, _)| *number);
    numbers.dedup_by_key(|(number, _)| *number);
    numbers.into_iter().map(|(number, method)| row(number, method)).collect()
}

fn row(number: i8, method: &HomingMethod) -> TokenStream {
    let number = self::number(number);
    let (name, pulse, text) = (&method.name, method.pulse, text(method));
    let target = method.target.as_deref().unwrap_or_default();
    let direction = match method.direction {
        None => quote!(None),
        Some(Way::Positive) => quote!(Some(Direction::Positive)),
        Some(Way::Negative) => quote!(Some(Direction::Negative)),
    };
    quote!(HomingInfo::new(#number, #name, #direction, #pulse, #target, #text))
}

/// What the drive does, in running text.
fn text(method: &HomingMethod) -> String {
    let cases = method.alternatives.iter().map(|Alternative { when, steps }| {
        let when = sentence(when);
        format!("{}: {}", when.trim_end_matches('.'), steps.join(" "))
    });
    let parts = method.about.iter().cloned().chain(method.steps.iter().cloned()).chain(cases);
    line(&parts.collect::<Vec<_>>().join(" "))
}

fn doc(scope: &Scope<'_>, method: &HomingMethod) -> Doc {
    let own = method.method.as_ref().map(|own| format!(" Method {own}.")).unwrap_or_default();
    let doc = Doc::new(format!("{}{}", sentence(&method.name), escape(&own))).maybe(method.about.as_deref());
    let doc = listed(doc, &method.steps);
    let doc = method.alternatives.iter().fold(doc, |doc, case| {
        let when = sentence(&case.when);
        listed(doc.text(&format!("{}:", when.trim_end_matches('.'))), &case.steps)
    });
    let doc = match method.parameters.as_slice() {
        [] => doc,
        parameters => doc.text(&escape(&format!("Parameters: {}.", parameters.join(", ")))),
    };
    doc.said(method.source.as_ref(), &method.origin, scope.device)
}

fn listed(doc: Doc, steps: &[String]) -> Doc {
    let steps = (1..).zip(steps).map(|(place, step)| format!("{place}. {}", escape(step)));
    let steps: Vec<String> = steps.collect();
    if steps.is_empty() { doc } else { doc.lines(steps) }
}
