//! Words of bits.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::doc::{Doc, escape, sentence};
use super::item::{Item, Space};
use super::literal::{self, number};
use super::names::{Names, snake};
use super::scope::Scope;
use crate::model::{Field, Mode, Word};

/// Names that words have besides their bits.
const RESERVED: &[&str] = &["state", "to_bytes", "from_bytes", "from_slice", "clone", "eq", "fmt", "hash"];

pub(super) fn items<'s>(scope: &'s Scope<'_>) -> Vec<Item<'s>> {
    scope.device.words.iter().filter_map(|one| item(scope, one)).collect()
}

fn item<'s>(scope: &'s Scope<'_>, one: &'s Word) -> Option<Item<'s>> {
    let name = scope.types.newtype(one.address)?;
    let item = Item::new(name.clone(), move || word(scope, one, name)).of(one).told(is_written(scope, one));
    let item = match one.address.index.0 {
        0x6040 | 0x6041 => item.of(&scope.device.modes),
        _ => item,
    };
    Some(match shows_state(scope, one) {
        true => item.of(&scope.device.states).using(Space::Root, &format_ident!("STATES")),
        false => item,
    })
}

/// Whether it is the statusword of a drive that has states.
fn shows_state(scope: &Scope<'_>, word: &Word) -> bool {
    word.address == super::types::address(0x6041) && !scope.device.states.is_empty()
}

/// A struct around the number with a method for each bit that has a meaning.
fn word(scope: &Scope<'_>, word: &Word, name: &Ident) -> (Doc, TokenStream) {
    let runtime = scope.runtime;
    let number = format_ident!("u{}", word.bits.next_power_of_two().max(8));
    let doc = Doc::new(format!("`{}` {}", word.address.index, sentence(&word.name)))
        .maybe(word.about.as_deref())
        .said(word.source.as_ref(), &word.origin, scope.device);
    let mut bits = Bits { is_written: is_written(scope, word), names: Names::with(RESERVED) };
    let general = word.fields.iter().filter(|field| !field.reserved && !field.per_mode);
    let mut fields: Vec<TokenStream> = general.map(|field| bits.line(field, None)).collect();
    fields.extend(of_modes(scope, word, &mut bits));
    let shows_state = shows_state(scope, word);
    let state = shows_state.then(|| state(name));
    let fields = (!fields.is_empty()).then(|| quote!(#runtime::bits! { #name: #number; #(#fields)* }));
    let display = display(scope, word, name, shows_state);
    let code = quote! {
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
        pub struct #name(pub #number);

        #state
        #fields

        #display

        #runtime::value!(#name as #number);
    };
    (doc, code)
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

fn state(name: &Ident) -> TokenStream {
    quote! {
        impl #name {
            /// The state that the word shows.
            pub fn state(self) -> Result<State, UnknownState> {
                STATES.decode(self.0)
            }
        }
    }
}

/// The bits that modes give a meaning to, named after the mode.
fn of_modes(scope: &Scope<'_>, word: &Word, lines: &mut Bits) -> Vec<TokenStream> {
    let mut all = Vec::new();
    for mode in &scope.device.modes {
        let bits = match word.address.index.0 {
            0x6040 => &mode.control_bits,
            0x6041 => &mode.status_bits,
            _ => continue,
        };
        let fields = bits.iter().filter(|field| !field.reserved);
        all.extend(fields.map(|field| lines.line(field, Some(mode))));
    }
    all
}

/// Whether a master writes the word, so that it has to set bits.
fn is_written(scope: &Scope<'_>, word: &Word) -> bool {
    scope.device.entry(word.address).is_some_and(|entry| entry.access.writable())
}

/// The fields of a word.
struct Bits {
    is_written: bool,
    names: Names,
}

impl Bits {
    /// The line of a field: how it is read, how it is written, and where it is.
    fn line(&mut self, field: &Field, mode: Option<&Mode>) -> TokenStream {
        let getter = self.names.claim(&snake(&format!("{} {}", id(mode), field.id)));
        let setter =
            self.is_written.then(|| self.names.claim(&snake(&format!("with {} {}", id(mode), field.id))));
        let setter = setter.into_iter();
        let (doc, low) = (doc(field, mode), literal::number(field.low));
        let last = (field.width() > 1).then(|| literal::number(field.high)).into_iter();
        quote!(#doc #getter #(, #setter)*: #low #(to #last)*;)
    }
}

fn id(mode: Option<&Mode>) -> &str {
    mode.map(|mode| mode.id.as_str()).unwrap_or_default()
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
    let values = field
        .values
        .iter()
        .map(|meaning| format!("- {}: {}", meaning.notation.written(meaning.value), escape(&meaning.name)));
    let edges = [("rising", &field.rising), ("falling", &field.falling)];
    let edges =
        edges.into_iter().filter_map(|(edge, text)| Some(format!("On the {edge} edge: {}", text.as_ref()?)));
    let doc = Doc::new(sentence(&format!("{}{in_mode}: {}", place(field), field.name)));
    let doc = edges.fold(doc.maybe(field.about.as_deref()), |doc, edge| doc.text(&escape(&edge)));
    if field.values.is_empty() { doc } else { doc.lines(values) }
}
