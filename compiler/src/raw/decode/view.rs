//! One value of the tree as serde sees it.

use serde::Deserializer;
use serde::de::{Error as _, Unexpected, Visitor};
use serde::forward_to_deserialize_any;

use super::access::{Choice, Items, Members};
use super::context::Context;
use super::error::Error;
use crate::source::{Key, Location, Node, Table, Value};

/// A value, a key, or the outermost table.
#[derive(Clone, Copy)]
pub(super) struct View<'d, 'c> {
    pub(super) at: Location,
    pub(super) input: Input<'d>,
    pub(super) context: &'c Context,
    /// Whether this is the outermost table, whose unknown keys are judged when all of it is read.
    top: bool,
}

#[derive(Clone, Copy)]
pub(super) enum Input<'d> {
    String(&'d str),
    Integer(i128),
    Float(f64),
    Boolean(bool),
    Datetime,
    Array(&'d [Node]),
    Table(&'d Table),
}

impl<'d, 'c> View<'d, 'c> {
    /// The outermost table.
    pub(super) fn top(table: &'d Table, context: &'c Context) -> Self {
        Self { at: table.at, input: Input::Table(table), context, top: true }
    }

    /// A key as a string.
    pub(super) fn key(key: &'d Key, context: &'c Context) -> Self {
        Self { at: key.at, input: Input::String(&key.name), context, top: false }
    }

    /// A value.
    pub(super) fn node(node: &'d Node, context: &'c Context) -> Self {
        let input = match &node.value {
            Value::String(text) => Input::String(text),
            Value::Integer(value) => Input::Integer(*value),
            Value::Float(value) => Input::Float(*value),
            Value::Boolean(value) => Input::Boolean(*value),
            Value::Datetime(_) => Input::Datetime,
            Value::Array(items) => Input::Array(items),
            Value::Table(table) => Input::Table(table),
        };
        Self { at: node.at, input, context, top: false }
    }

    /// That this value is not of the type that it is read as.
    fn mismatch(self, visitor: &dyn serde::de::Expected) -> Error {
        let found = match self.input {
            Input::String(text) => Unexpected::Str(text),
            Input::Integer(_) => Unexpected::Signed(0),
            Input::Float(value) => Unexpected::Float(value),
            Input::Boolean(value) => Unexpected::Bool(value),
            Input::Datetime => Unexpected::Other("a date"),
            Input::Array(_) => Unexpected::Seq,
            Input::Table(_) => Unexpected::Map,
        };
        Error::invalid_type(found, visitor).at(self.at)
    }

    /// Hands the value to the visitor as what it is.
    fn visit<V: Visitor<'d>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.input {
            Input::String(text) => visitor.visit_borrowed_str(text),
            Input::Integer(value) => visit_integer(value, visitor),
            Input::Float(value) => visitor.visit_f64(value),
            Input::Boolean(value) => visitor.visit_bool(value),
            Input::Datetime => Err(self.mismatch(&visitor)),
            Input::Array(items) => {
                let mut items = Items::new(items, self.context);
                let value = visitor.visit_seq(&mut items)?;
                items.finish().map(|()| value)
            }
            Input::Table(table) => visitor.visit_map(Members::new(table, self.context)),
        }
    }
}

/// In the narrowest of the types that every visitor knows.
fn visit_integer<'d, V: Visitor<'d>>(value: i128, visitor: V) -> Result<V::Value, Error> {
    match (i64::try_from(value), u64::try_from(value)) {
        (Ok(value), _) => visitor.visit_i64(value),
        (_, Ok(value)) => visitor.visit_u64(value),
        _ => visitor.visit_i128(value),
    }
}

/// Methods for integers that name the range which a value leaves.
macro_rules! integers {
    ($($method:ident $visit:ident $kind:ident)+) => {$(
        fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
            let Input::Integer(value) = self.input else { return self.deserialize_any(visitor) };
            match $kind::try_from(value) {
                Ok(value) => visitor.$visit(value),
                Err(_) => Err(Error::range(value, $kind::MIN, $kind::MAX)),
            }
            .map_err(|error| error.at(self.at))
        }
    )+};
}

impl<'de> Deserializer<'de> for View<'de, '_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.visit(visitor).map_err(|error| error.at(self.at))
    }

    integers! {
        deserialize_u8 visit_u8 u8
        deserialize_u16 visit_u16 u16
        deserialize_u32 visit_u32 u32
        deserialize_u64 visit_u64 u64
        deserialize_u128 visit_u128 u128
        deserialize_i8 visit_i8 i8
        deserialize_i16 visit_i16 i16
        deserialize_i32 visit_i32 i32
        deserialize_i64 visit_i64 i64
        deserialize_i128 visit_i128 i128
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self).map_err(|error| error.at(self.at))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        match self.input {
            Input::Table(_) if self.top => self.context.know(fields),
            Input::Table(table) => self.context.judge(table, self.at, fields),
            // A struct could be read from the values alone; in a description each value has its key.
            Input::Array(_) => return Err(self.mismatch(&visitor)),
            _ => {}
        }
        self.deserialize_any(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        let choice = match self.input {
            Input::String(_) => Choice::word(self),
            Input::Table(table) => Choice::table(table, self.context)?,
            _ => return Err(self.mismatch(&visitor)),
        };
        visitor.visit_enum(choice).map_err(|error| error.at(self.at))
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_unit()
    }

    forward_to_deserialize_any! {
        bool f32 f64 char str string bytes byte_buf unit unit_struct seq tuple tuple_struct map identifier
    }
}
