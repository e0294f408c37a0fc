//! The format as written: how a description is read, table by table, and a struct for each table of which something is
//! resolved later. Tables that are kept as they are have their struct in the model.
//!
//! The doc comments of the structs are the reference of the format; `compiler/docs/format.md` is made from them.

mod assumed;
mod axes;
mod compose;
mod configuration;
mod coordinates;
pub(crate) mod decode;
mod device;
mod errata;
mod extent;
mod fact;
mod front;
mod head;
mod known;
mod laid;
mod like;
mod lints;
mod member;
mod misplaced;
mod mode;
mod object;
mod pdo;
mod picture;
mod read;
mod read_object;
#[cfg(feature = "schema")]
pub mod schema;
mod unit;
mod values;
mod word;

pub(crate) use assumed::entry_keys;
pub use axes::{RawAxes, RawShift};
#[cfg(feature = "cli")]
pub(crate) use compose::over_profile;
pub use configuration::{RawConfiguration, RawWrite};
pub use coordinates::{RawAxisGroup, RawCoordinates, RawGroup};
pub use device::RawDevice;
pub use fact::{RawAssumed, RawFacts, RawSource};
pub use front::{RawProcedure, RawStep};
pub use head::RawHead;
pub(crate) use known::section_keys;
pub(crate) use laid::SHARED;
pub use lints::LintSetting;
pub use member::{Reading, read};
pub use mode::RawMode;
pub use object::{Ignored, RawEntries, RawEntry, RawObject, RawObjectHead, RawTrigger};
pub use pdo::{RawMapped, RawPdo, RawSyncManager};
#[cfg(feature = "import")]
pub(crate) use picture::MOST as MOST_OF_PICTURE;
pub use picture::pictures;
pub use unit::{RawAxisUnit, RawUnit};
pub use values::RawValues;
pub use word::RawWord;

/// Declares a table of which something is resolved later. `by code: "..."` names the field that holds what is read of the
/// key, and says what the key has to be; `called index`, what a key is called that is read later.
macro_rules! raw {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident $(by $key:ident: $expected:literal)? $(called $called:ident)? { $($fields:tt)* }
    )*) => {
        $(
            $(#[$meta])*
            #[derive(Debug, Default, serde::Deserialize)]
            #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
            #[serde(rename_all = "kebab-case")]
            pub struct $name {
                $($fields)*
                /// The key that it stands under.
                #[serde(skip)]
                pub key: String,
                /// Where its facts are from.
                #[serde(skip)]
                pub source: Option<$crate::model::Source>,
                /// Where it was written.
                #[serde(skip)]
                pub origin: $crate::source::Origin,
            }

            impl $crate::model::Table for $name {
                const KEY: &'static str = concat!("" $(, $expected)?);
                const CALLED: &'static str = concat!("" $(, stringify!($key))? $(, stringify!($called))?);

                fn stand(
                    &mut self,
                    key: &str,
                    source: Option<$crate::model::Source>,
                    origin: $crate::source::Origin,
                ) -> bool {
                    self.key = key.to_owned();
                    self.source = source;
                    self.origin = origin;
                    $crate::model::table::stand!(self, key $(, $key)?);
                    true
                }
            }
        )*
    };
}
use raw;
