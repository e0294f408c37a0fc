//! The keys that tables can have, by where they stand.

use super::read::Read;
use super::{
    RawAxes, RawConfiguration, RawCoordinates, RawHead, RawMode, RawObject, RawPdo, RawProcedure,
    RawSyncManager, RawUnit, RawWord,
};
use crate::model::*;

macro_rules! keys_of_tables {
    ($($name:ident $field:ident $key:literal $shape:ident $table:ty,)*) => {
        /// The keys that a table of a section can have.
        pub(crate) fn section_keys(section: Section) -> Vec<&'static str> {
            match section {
                $(Section::$name => <$table as Read>::keys(),)*
            }
        }
    };
}
for_each_section!(keys_of_tables);
