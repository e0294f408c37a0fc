//! Items before it is known in which module they stand.

use std::any::Any;

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;

use super::doc::Doc;
use crate::model::{Compare, Pair};

/// The modules that every device has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Space {
    Root,
    Objects,
    Configurations,
    Units,
    Dictionary,
}

/// An item with all that belongs to it, such as a struct with what is implemented for it.
pub(super) struct Item<'a> {
    /// The names it brings to its module. By the first it is known.
    pub(super) names: Vec<Ident>,
    /// What of the model it is made of.
    pub(super) parts: Vec<Part<'a>>,
    /// The items that it names.
    pub(super) uses: Vec<(Space, Ident)>,
    pub(super) reach: Reach,
    code: Code<'a>,
}

/// Writes an item, once it is known which module holds what it names.
type Code<'a> = Box<dyn Fn(&Holders<'_>) -> (Doc, TokenStream) + 'a>;

/// From where an item can be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    Public,
    /// From the modules of the family.
    Family,
    /// It is a device's own: no two share it.
    Own,
}

/// A part of the model that an item is made of.
pub(super) enum Part<'a> {
    Model(&'a dyn Told),
    /// What follows from the model.
    Word(String),
}

/// A part of the model, whatever its type.
pub(super) trait Told {
    fn as_any(&self) -> &dyn Any;
    fn is_one(&self, other: &dyn Told, pair: &Pair<'_>) -> bool;
}

impl<T: Compare + 'static> Told for T {
    fn as_any(&self) -> &dyn Any {
        self
    }

    fn is_one(&self, other: &dyn Told, pair: &Pair<'_>) -> bool {
        other.as_any().downcast_ref().is_some_and(|other| pair.is_one(self, other))
    }
}

/// The devices that have an item.
#[derive(Debug, Clone)]
pub(super) struct Holders<'a> {
    /// The places of these devices in the family.
    pub(super) places: Vec<u16>,
    /// Their names.
    pub(super) names: Vec<&'a str>,
    /// Whether there are no others.
    pub(super) is_all: bool,
}

impl<'a> Item<'a> {
    /// An item of this name.
    pub(super) fn new(name: Ident, code: impl Fn() -> (Doc, TokenStream) + 'a) -> Self {
        Self::held(name, move |_| code())
    }

    /// An item that says who has it.
    pub(super) fn held(name: Ident, code: impl Fn(&Holders<'_>) -> (Doc, TokenStream) + 'a) -> Self {
        let (names, code) = (vec![name], Box::new(code));
        Self { names, parts: Vec::new(), uses: Vec::new(), reach: Reach::Public, code }
    }

    /// It brings this name, too.
    pub(super) fn with_name(mut self, name: Ident) -> Self {
        self.names.push(name);
        self
    }

    pub(super) fn reaching(mut self, reach: Reach) -> Self {
        self.reach = reach;
        self
    }

    /// It is made of this part of the model.
    pub(super) fn of<T: Compare + 'static>(mut self, part: &'a T) -> Self {
        self.parts.push(Part::Model(part));
        self
    }

    /// It depends on this, which follows from the model.
    pub(super) fn told(mut self, word: impl ToString) -> Self {
        self.parts.push(Part::Word(word.to_string()));
        self
    }

    /// It names another item.
    pub(super) fn using(mut self, space: Space, name: &Ident) -> Self {
        self.uses.push((space, name.clone()));
        self
    }

    /// Something more about it for each of several things.
    pub(super) fn each<T>(self, things: impl IntoIterator<Item = T>, more: impl Fn(Self, T) -> Self) -> Self {
        things.into_iter().fold(self, more)
    }

    /// Its code, as these have it.
    pub(super) fn tokens(&self, holders: &Holders<'_>) -> TokenStream {
        let (doc, code) = (self.code)(holders);
        documented(&doc, code)
    }

    /// Its code in the module of a family, where it says which members have it if not all do.
    pub(super) fn shared_tokens(&self, holders: &Holders<'_>) -> TokenStream {
        let (doc, code) = (self.code)(holders);
        let is_told = !holders.is_all && self.reach == Reach::Public && !doc.is_empty();
        let doc = if is_told { doc.text(&holders.shown()) } else { doc };
        documented(&doc, code)
    }
}

/// The code behind its documentation: moved, where `quote!` would copy each token.
fn documented(doc: &Doc, code: TokenStream) -> TokenStream {
    [doc.to_token_stream(), code].into_iter().collect()
}

impl Part<'_> {
    /// Whether it is one with a part of another device.
    pub(super) fn is_one(&self, other: &Self, pair: &Pair<'_>) -> bool {
        match (self, other) {
            (Self::Model(first), Self::Model(second)) => first.is_one(*second, pair),
            (Self::Word(first), Self::Word(second)) => first == second,
            _ => false,
        }
    }
}

impl Holders<'_> {
    /// A device that is alone.
    pub(super) fn alone() -> Self {
        Self { places: vec![0], names: Vec::new(), is_all: true }
    }

    fn shown(&self) -> String {
        format!("Of these only: {}.", super::doc::escape(&self.names.join(", ")))
    }
}
