//! The keys that a struct takes, asked of serde.

use std::cell::Cell;

use serde::de::{Deserialize, Deserializer, Error as _, Visitor};
use serde::forward_to_deserialize_any;

use super::error::Error;

/// The keys of a table that is read as this struct.
pub(crate) fn keys<'d, T: Deserialize<'d>>() -> &'static [&'static str] {
    let keys = Cell::new(&[][..]);
    // it is told the keys, and given nothing
    let _ = T::deserialize(Asked(&keys));
    keys.get()
}

/// Hears which keys are asked for.
struct Asked<'k>(&'k Cell<&'static [&'static str]>);

impl<'de> Deserializer<'de> for Asked<'_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        Err(Error::custom("nothing is there"))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.0.set(fields);
        self.deserialize_any(visitor)
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}
