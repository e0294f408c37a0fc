//! A description, decoded: what its sections hold.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::read::Sections;
use super::{
    LintSetting, RawAxes, RawConfiguration, RawCoordinates, RawHead, RawMode, RawObject, RawPdo,
    RawProcedure, RawSyncManager, RawUnit, RawWord,
};
use crate::model::*;

/// What a section holds: one table, or several.
macro_rules! held {
    (Single $table:ty) => { Option<$table> };
    ($shape:ident $table:ty) => { Vec<$table> };
}

/// Reads what a section holds.
macro_rules! read {
    (Single $sections:ident $name:ident) => {
        $sections.single(Section::$name)
    };
    (List $sections:ident $name:ident) => {
        $sections.list(Section::$name)
    };
    ($shape:ident $sections:ident $name:ident) => {
        $sections.map(Section::$name)
    };
}

macro_rules! device {
    ($($name:ident $field:ident $key:literal $shape:ident $table:ident,)*) => {
        /// A description, decoded table by table.
        #[derive(Debug)]
        pub struct RawDevice {
            /// The name of the description's folder, with the member's for a family.
            pub id: String,
            $(
                #[doc = concat!("`[", $key, "]`.")]
                pub $field: held!($shape $table),
            )*
            /// `[lints]`: levels by rule or group.
            pub lints: Vec<LintSetting>,
            /// What no source states.
            pub assumptions: Vec<Assumption>,
            /// The objects of the profiles by id, whether or not they are mentioned.
            pub offered: Arc<BTreeMap<String, Index>>,
            /// Every table of a section.
            pub written: Vec<Written>,
        }

        impl Sections<'_> {
            /// Reads all sections.
            pub(super) fn device(mut self, id: String, offered: Arc<BTreeMap<String, Index>>) -> RawDevice {
                $(let $field: held!($shape $table) = read!($shape self $name);)*
                let lints = self.lints();
                let (assumptions, written) = self.finish();
                RawDevice { id, $($field,)* lints, assumptions, offered, written }
            }
        }
    };
}
for_each_section!(device);
