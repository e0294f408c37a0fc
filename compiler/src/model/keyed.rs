//! Tables from numbers to what they mean, as lists.

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor};

use crate::source::keys;

/// A whole number as a key.
pub(crate) struct Number {
    pub(crate) value: i64,
    /// The key as it is written.
    pub(crate) key: String,
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let key = String::deserialize(deserializer)?;
        let wrong = || Error::custom(format!("`{key}` means nothing here, expected a whole number"));
        let value = keys::number(&key).ok_or_else(wrong)?;
        Ok(Self { value, key })
    }
}

/// A number, or a range of numbers such as `4..=6`, as a key.
pub(crate) struct Range<T> {
    pub(crate) first: T,
    pub(crate) last: T,
    /// The key as it is written.
    pub(crate) key: String,
}

impl<'de, T: TryFrom<i64> + PartialOrd + Copy> Deserialize<'de> for Range<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let key = String::deserialize(deserializer)?;
        match keys::range::<T>(&key) {
            Some(range) => Ok(Self { first: *range.start(), last: *range.end(), key }),
            None => {
                let expected = "a number within bounds, or a range of them such as \"4..=6\"";
                Err(Error::custom(format!("`{key}` means nothing here, expected {expected}")))
            }
        }
    }
}

/// The keys of a table with their values, in the order in which they were written.
pub(crate) fn keyed<'de, K, V, D>(deserializer: D) -> Result<Vec<(K, V)>, D::Error>
where
    K: Deserialize<'de>,
    V: Deserialize<'de>,
    D: Deserializer<'de>,
{
    deserializer.deserialize_map(Entries(PhantomData))
}

struct Entries<K, V>(PhantomData<(K, V)>);

impl<'de, K: Deserialize<'de>, V: Deserialize<'de>> Visitor<'de> for Entries<K, V> {
    type Value = Vec<(K, V)>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(entries)
    }
}

/// Declares lists that descriptions write as tables: `List of Item as Table`.
macro_rules! list {
    ($($(#[$meta:meta])* $name:ident of $item:ty as $table:ty;)+) => {
        $(
            $(#[$meta])*
            #[derive(Debug, Clone, Default, PartialEq)]
            #[cfg_attr(feature = "json", derive(serde::Serialize))]
            #[cfg_attr(feature = "json", serde(transparent))]
            pub struct $name(pub Vec<$item>);

            impl std::ops::Deref for $name {
                type Target = Vec<$item>;

                fn deref(&self) -> &Vec<$item> {
                    &self.0
                }
            }

            impl $crate::model::Compare for $name {
                fn shown(&self) -> String {
                    self.0.shown()
                }

                fn compare(
                    &self,
                    other: &Self,
                    path: &mut $crate::model::FieldPath,
                    found: &mut dyn FnMut($crate::model::Difference),
                ) {
                    self.0.compare(&other.0, path, found);
                }

                fn walk(
                    &self,
                    path: &mut $crate::model::FieldPath,
                    walker: &mut dyn $crate::model::Walker,
                ) {
                    self.0.walk(path, walker);
                }
            }

            impl<'a> IntoIterator for &'a $name {
                type Item = &'a $item;
                type IntoIter = std::slice::Iter<'a, $item>;

                fn into_iter(self) -> Self::IntoIter {
                    self.0.iter()
                }
            }

            #[cfg(feature = "schema")]
            impl schemars::JsonSchema for $name {
                fn inline_schema() -> bool {
                    true
                }

                fn schema_name() -> std::borrow::Cow<'static, str> {
                    stringify!($name).into()
                }

                /// A table in a description, a list in the model.
                fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                    match generator.contract().is_deserialize() {
                        true => generator.subschema_for::<std::collections::BTreeMap<String, $table>>(),
                        false => generator.subschema_for::<Vec<$item>>(),
                    }
                }
            }
        )+
    };
}
pub(crate) use list;
