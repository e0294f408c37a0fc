//! What a table of a description has besides its own keys.

use super::Source;
use crate::source::Origin;
use crate::source::keys::number;

/// A table that is read from a description and kept as it is: its key, its source and its origin are added to what it
/// says.
pub trait Table {
    /// What its key has to be, for people.
    const KEY: &'static str;

    /// What its key is called; nothing if there is one such table, or a list.
    const CALLED: &'static str;

    /// Says under which key and where the table stands, and where its facts are from; false if the key cannot be read.
    fn stand(&mut self, key: &str, source: Option<Source>, origin: Origin) -> bool;
}

/// A key as a table keeps it.
pub(crate) trait Key: Sized {
    /// Reads it as descriptions write it.
    fn read(text: &str) -> Option<Self>;
}

impl Key for String {
    fn read(text: &str) -> Option<Self> {
        Some(text.to_owned())
    }
}

macro_rules! numbers {
    ($($kind:ty)+) => {
        $(
            impl Key for $kind {
                fn read(text: &str) -> Option<Self> {
                    number(text).and_then(|number| Self::try_from(number).ok())
                }
            }
        )+
    };
}
numbers! { u8 i8 u16 i16 u32 }

/// Declares tables. `by id: "..."` names the field that holds the key, and says what the key has to be; a table without
/// it is there once or stands in a list.
macro_rules! table {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident $(by $key:ident $(to $last:ident)?: $expected:literal)? { $($fields:tt)* }
    )*) => {
        $(
            $(#[$meta])*
            #[derive(Debug, Clone, Default, PartialEq, serde::Deserialize)]
            #[cfg_attr(feature = "json", derive(serde::Serialize))]
            #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
            #[serde(rename_all(deserialize = "kebab-case"))]
            pub struct $name {
                $($fields)*
                /// Where its facts are from.
                #[serde(skip_deserializing)]
                pub source: Option<$crate::model::Source>,
                /// Where it was written.
                #[serde(rename(serialize = "provenance"), skip_deserializing)]
                pub origin: $crate::source::Origin,
            }

            $crate::model::compared::compared! { struct $name [$($key)?] {
                $($fields)*
                pub source: Option<$crate::model::Source>,
                pub origin: $crate::source::Origin,
            } }

            impl $crate::model::Table for $name {
                const KEY: &'static str = concat!("" $(, $expected)?);
                const CALLED: &'static str = concat!("" $(, stringify!($key))?);

                fn stand(
                    &mut self,
                    key: &str,
                    source: Option<$crate::model::Source>,
                    origin: $crate::source::Origin,
                ) -> bool {
                    self.source = source;
                    self.origin = origin;
                    $crate::model::table::stand!(self, key $(, $key $(to $last)?)?);
                    true
                }
            }
        )*
    };
}
pub(crate) use table;

/// Keeps the key of a table.
macro_rules! stand {
    ($this:ident, $text:ident) => {
        let _ = $text;
    };
    ($this:ident, $text:ident, $key:ident) => {
        let Some(key) = $crate::model::table::Key::read($text) else { return false };
        $this.$key = key;
    };
    ($this:ident, $text:ident, $first:ident to $last:ident) => {
        let Some(range) = $crate::source::keys::range::<u16>($text) else { return false };
        $this.$first = (*range.start()).into();
        $this.$last = (*range.end()).into();
    };
}
pub(crate) use stand;

/// Declares the parts of tables, and the words that they choose from: read as written in descriptions.
macro_rules! part {
    ($($(#[$meta:meta])* pub $kind:ident $name:ident $body:tt)*) => {
        $(
            $crate::model::compared::compared! { $kind $name [] $body }

            $(#[$meta])*
            #[derive(Debug, Clone, PartialEq, serde::Deserialize)]
            #[cfg_attr(feature = "json", derive(serde::Serialize))]
            #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
            #[serde(rename_all(serialize = "snake_case", deserialize = "kebab-case"))]
            pub $kind $name $body
        )*
    };
}
pub(crate) use part;
