//! What the stages before the lints report: faults that leave nothing to go on with.
//!
//! One file a fault. A stage says `faults::UNKNOWN_KEY`; the list is for those who document or test them all.

mod duplicate_definition;
mod include_cycle;
mod invalid_toml;
mod invalid_value;
mod missing_file;
mod missing_key;
mod outside_include;
mod unknown_key;
mod unknown_profile;
mod unknown_reference;
mod unreadable_file;
mod wrong_type;

pub(crate) use duplicate_definition::DUPLICATE_DEFINITION;
pub(crate) use include_cycle::INCLUDE_CYCLE;
pub(crate) use invalid_toml::INVALID_TOML;
pub(crate) use invalid_value::INVALID_VALUE;
pub(crate) use missing_file::MISSING_FILE;
pub(crate) use missing_key::MISSING_KEY;
pub(crate) use outside_include::OUTSIDE_INCLUDE;
pub(crate) use unknown_key::UNKNOWN_KEY;
pub(crate) use unknown_profile::UNKNOWN_PROFILE;
pub(crate) use unknown_reference::UNKNOWN_REFERENCE;
pub(crate) use unreadable_file::UNREADABLE_FILE;
pub(crate) use wrong_type::WRONG_TYPE;

use super::Rule;

/// Every fault, by name.
pub static ALL: &[&Rule] = &[
    &DUPLICATE_DEFINITION,
    &INCLUDE_CYCLE,
    &INVALID_TOML,
    &INVALID_VALUE,
    &MISSING_FILE,
    &MISSING_KEY,
    &OUTSIDE_INCLUDE,
    &UNKNOWN_KEY,
    &UNKNOWN_PROFILE,
    &UNKNOWN_REFERENCE,
    &UNREADABLE_FILE,
    &WRONG_TYPE,
];
