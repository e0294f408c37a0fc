//! Words of bits.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::doc::{Doc, escape, sentence};
use super::literal::{self, number, parsed};
use super::names::{Names, snake};
use super::scope::Scope;
use crate::model::{Field, Mode, Word};

/// Names that words have besides their bits.
const RESERVED: &[&str] = &["state", "to_bytes", "from_bytes", "from_slice", "clone", "eq", "fmt", "hash"];

pub(super) fn items(scope: &Scope<'_>) -> TokenStream {
    scope.device.words.iter().filter_map(|one| word(scope, one)).collect()
}

/// A struct around the number with a method for each bit that has a meaning.
fn word(scope: &Scope<'_>, word: &Word) -> Option<TokenStream> {
    let (runtime, name) = (scope.runtime, scope.types.newtype(word.address)?);
    let number = format_ident!("u{}", word.bits.next_power_of_two().max(8));
    let doc = Doc::new(format!("`{}` {}", word.address.index, sentence(&word.name)))
        .maybe(word.about.as_deref())
        .said(word.source.as_ref(), &word.origin, scope.device);
    let mut bits =
        Bits { number: &number, is_written: is_written(scope, word), names: Names::with(RESERVED) };
    let general = word.fields.iter().filter(|field| !field.reserved && !field.per_mode);
    let mut methods: Vec<TokenStream> = general.map(|field| bits.methods(field, None)).collect();
    methods.extend(of_modes(scope, word, &mut bits));
    let shows_state = word.address == super::types::address(0x6041) && !scope.device.states.is_empty();
    let (state, display) = (shows_state.then(state), display(scope, word, name, shows_state));
    Some(quote! {
        #doc
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
        pub struct #name(pub #number);

        impl #name {
            #state
            #(#methods)*
        }

        #display

        #runtime::value!(#name as #number);
    })
}

/// The bits of the statusword that show the state (CiA 402, statusword); a drive may use others as well, and they are told
/// beside it.
const STATE_BITS: u16 = 0x006F;

/// The word as people read it: its state, and what else is set.
fn display(scope: &Scope<'_>, word: &Word, name: &Ident, shows_state: bool) -> TokenStream {
    let runtime = scope.runtime;
    let patterns = scope.device.states.iter().filter_map(|state| state.pattern.as_ref());
    let of_states = STATE_BITS & patterns.fold(0, |bits, pattern| bits | pattern.mask());
    let fields = word.fields.iter().filter(|field| !field.reserved && !field.per_mode).map(|field| {
        let (low, bits, name) = (number(field.low), number(field.width()), field.id.replace('-', " "));
        let is_of_state =
            shows_state && 1_u16.checked_shl(field.low.into()).is_some_and(|bit| of_states & bit != 0);
        let of_state = is_of_state.then(|| quote!(.of_state()));
        quote!(BitField::new(#low, #bits, #name)#of_state)
    });
    let state = match shows_state {
        true => quote!(self.state().ok()),
        false => quote!(None::<&str>),
    };
    quote! {
        impl core::fmt::Display for #name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                const FIELDS: &[BitField] = &[#(#fields),*];
                #runtime::object::show_word(f, self.0.into(), #state, FIELDS)
            }
        }
    }
}

fn state() -> TokenStream {
    quote! {
        /// The state that the word shows.
        pub fn state(self) -> Result<State, UnknownState> {
            STATES.decode(self.0)
        }
    }
}

/// The bits that modes give a meaning to, named after the mode.
fn of_modes(scope: &Scope<'_>, word: &Word, methods: &mut Bits<'_>) -> Vec<TokenStream> {
    let mut all = Vec::new();
    for mode in &scope.device.modes {
        let bits = match word.address.index.0 {
            0x6040 => &mode.control_bits,
            0x6041 => &mode.status_bits,
            _ => continue,
        };
        let fields = bits.iter().filter(|field| !field.reserved);
        all.extend(fields.map(|field| methods.methods(field, Some(mode))));
    }
    all
}

/// Whether a master writes the word, so that it has to set bits.
fn is_written(scope: &Scope<'_>, word: &Word) -> bool {
    scope.device.entry(word.address).is_some_and(|entry| entry.access.writable())
}

/// The methods of a word's bits.
struct Bits<'a> {
    number: &'a Ident,
    is_written: bool,
    names: Names,
}

impl Bits<'_> {
    fn methods(&mut self, field: &Field, mode: Option<&Mode>) -> TokenStream {
        let getter = self.getter(field, mode);
        let setter = self.is_written.then(|| self.setter(field, mode));
        quote!(#getter #setter)
    }

    fn getter(&mut self, field: &Field, mode: Option<&Mode>) -> TokenStream {
        let name = self.names.claim(&snake(&format!("{} {}", id(mode), field.id)));
        let (doc, number, low) = (doc(field, mode), self.number, literal::number(field.low));
        if field.width() == 1 {
            return quote!(#doc pub const fn #name(self) -> bool { self.0 & 1 << #low != 0 });
        }
        let mask = mask(field);
        quote!(#doc pub const fn #name(self) -> #number { self.0 >> #low & #mask })
    }

    fn setter(&mut self, field: &Field, mode: Option<&Mode>) -> TokenStream {
        let name = self.names.claim(&snake(&format!("with {} {}", id(mode), field.id)));
        let (number, low) = (self.number, literal::number(field.low));
        let (argument, mask, value) = if field.width() == 1 {
            (quote!(on: bool), quote!(1), quote!((on as #number)))
        } else {
            let mask = mask(field);
            (quote!(value: #number), mask.clone(), quote!((value & #mask)))
        };
        let doc = Doc::new(format!("The word with {} as given.", place(field)));
        quote! {
            #doc
            #[must_use]
            pub const fn #name(self, #argument) -> Self {
                Self(self.0 & !(#mask << #low) | #value << #low)
            }
        }
    }
}

fn id(mode: Option<&Mode>) -> &str {
    mode.map(|mode| mode.id.as_str()).unwrap_or_default()
}

/// As many ones as the field is wide.
fn mask(field: &Field) -> TokenStream {
    parsed(&format!("0x{:X}", field.mask() >> field.low))
}

fn place(field: &Field) -> String {
    if field.width() == 1 {
        format!("bit {}", field.low)
    } else {
        format!("bits {} to {}", field.low, field.high)
    }
}

fn doc(field: &Field, mode: Option<&Mode>) -> Doc {
    let in_mode = mode.map(|mode| format!(" in mode {} ({})", mode.code, mode.id)).unwrap_or_default();
    let values = field.values.iter().map(|meaning| format!("- {}: {}", meaning.value, escape(&meaning.name)));
    let edges = [("rising", &field.rising), ("falling", &field.falling)];
    let edges =
        edges.into_iter().filter_map(|(edge, text)| Some(format!("On the {edge} edge: {}", text.as_ref()?)));
    let doc = Doc::new(sentence(&format!("{}{in_mode}: {}", place(field), field.name)));
    let doc = edges.fold(doc.maybe(field.about.as_deref()), |doc, edge| doc.text(&escape(&edge)));
    if field.values.is_empty() { doc } else { doc.lines(values) }
}
