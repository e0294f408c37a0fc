//! What is inside of arrays, tables and choices.

use serde::Deserializer;
use serde::de::{DeserializeSeed, EnumAccess, Error as _, MapAccess, SeqAccess, VariantAccess, Visitor};

use super::context::Context;
use super::error::Error;
use super::view::{Input, View};
use crate::source::{Member, Node, Table};

/// The elements of an array.
pub(super) struct Items<'d, 'c> {
    items: std::slice::Iter<'d, Node>,
    count: usize,
    context: &'c Context,
}

impl<'d, 'c> Items<'d, 'c> {
    pub(super) fn new(items: &'d [Node], context: &'c Context) -> Self {
        Self { items: items.iter(), count: items.len(), context }
    }

    /// Whether every element was wanted.
    pub(super) fn finish(mut self) -> Result<(), Error> {
        let wanted = self.count - self.items.len();
        match self.items.next() {
            Some(item) => {
                Err(Error::custom(format!("expected {wanted} elements, found {}", self.count)).at(item.at))
            }
            None => Ok(()),
        }
    }
}

impl<'d> SeqAccess<'d> for &mut Items<'d, '_> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'d>>(&mut self, seed: T) -> Result<Option<T::Value>, Error> {
        let item = self.items.next();
        item.map(|item| {
            let value = seed.deserialize(View::node(item, self.context));
            value.map_err(|error| error.at(item.at))
        })
        .transpose()
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len())
    }
}

/// The members of a table, in the order in which they were written.
pub(super) struct Members<'d, 'c> {
    members: std::slice::Iter<'d, Member>,
    current: Option<&'d Member>,
    context: &'c Context,
}

impl<'d, 'c> Members<'d, 'c> {
    pub(super) fn new(table: &'d Table, context: &'c Context) -> Self {
        Self { members: table.members.iter(), current: None, context }
    }
}

impl<'d> MapAccess<'d> for Members<'d, '_> {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'d>>(&mut self, seed: K) -> Result<Option<K::Value>, Error> {
        self.current = self.members.next();
        let key = self.current.map(|member| seed.deserialize(View::key(&member.key, self.context)));
        key.transpose().map_err(Error::in_key)
    }

    fn next_value_seed<V: DeserializeSeed<'d>>(&mut self, seed: V) -> Result<V::Value, Error> {
        let Some(member) = self.current else {
            return Err(Error::custom("a value was asked for before its key"));
        };
        let value = seed.deserialize(View::node(&member.node, self.context));
        value.map_err(|error| error.at(member.node.at).under(&member.key.name))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.members.len())
    }
}

/// One of several: a word, or a table whose only key is the word.
pub(super) struct Choice<'d, 'c> {
    word: View<'d, 'c>,
    value: Option<&'d Member>,
}

impl<'d, 'c> Choice<'d, 'c> {
    /// The choice written as a word.
    pub(super) fn word(word: View<'d, 'c>) -> Self {
        Self { word, value: None }
    }

    /// The choice written as a table.
    pub(super) fn table(table: &'d Table, context: &'c Context) -> Result<Self, Error> {
        match table.members.as_slice() {
            [member] => Ok(Self { word: View::key(&member.key, context), value: Some(member) }),
            [_, second, ..] => {
                let count = table.members.len();
                Err(Error::custom(format!("expected a table with one key, found {count}"))
                    .at(second.key.at)
                    .in_key())
            }
            [] => Err(Error::custom("expected a table with one key, found none").at(table.at)),
        }
    }

    /// The value that belongs to the word.
    fn content(self) -> Result<View<'d, 'c>, Error> {
        match (self.value, self.word.input) {
            (Some(member), _) => Ok(View::node(&member.node, self.word.context)),
            (None, Input::String(word)) => {
                Err(Error::custom(format!("`{word}` needs a value, as `{{ {word} = 1 }}`")))
            }
            (None, _) => Err(Error::custom("a value is missing")),
        }
    }
}

impl<'d> EnumAccess<'d> for Choice<'d, '_> {
    type Error = Error;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'d>>(self, seed: V) -> Result<(V::Value, Self), Error> {
        let word = seed.deserialize(self.word);
        let word = word.map_err(|error| if self.value.is_some() { error.in_key() } else { error })?;
        Ok((word, self))
    }
}

impl<'d> VariantAccess<'d> for Choice<'d, '_> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        match self.value {
            Some(member) => {
                let message = format!("`{}` takes no value, write it as a string", member.key.name);
                Err(Error::custom(message).at(member.node.at))
            }
            None => Ok(()),
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'d>>(self, seed: T) -> Result<T::Value, Error> {
        seed.deserialize(self.content()?)
    }

    fn tuple_variant<V: Visitor<'d>>(self, len: usize, visitor: V) -> Result<V::Value, Error> {
        self.content()?.deserialize_tuple(len, visitor)
    }

    fn struct_variant<V: Visitor<'d>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.content()?.deserialize_struct("", fields, visitor)
    }
}
