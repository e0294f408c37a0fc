//! What the stages before the lints report: faults that leave nothing to go on with.
//!
//! One file a fault. A stage says `faults::UNKNOWN_KEY`; the list is for those who document or test them all.

mod colliding_axes;
mod duplicate_definition;
mod duplicate_index;
mod exceeded_limit;
mod forbidden_character;
mod include_cycle;
mod invalid_toml;
mod invalid_value;
mod misquoted_erratum;
mod missing_file;
mod missing_key;
mod outside_include;
mod unfit_value;
mod unknown_key;
mod unknown_profile;
mod unknown_reference;
mod unreadable_file;
mod untyped_entry;
mod wrong_type;

pub(crate) use colliding_axes::COLLIDING_AXES;
pub(crate) use duplicate_definition::DUPLICATE_DEFINITION;
pub(crate) use duplicate_index::DUPLICATE_INDEX;
pub(crate) use exceeded_limit::EXCEEDED_LIMIT;
pub(crate) use forbidden_character::FORBIDDEN_CHARACTER;
pub(crate) use include_cycle::INCLUDE_CYCLE;
pub(crate) use invalid_toml::INVALID_TOML;
pub(crate) use invalid_value::INVALID_VALUE;
pub(crate) use misquoted_erratum::MISQUOTED_ERRATUM;
pub(crate) use missing_file::MISSING_FILE;
pub(crate) use missing_key::MISSING_KEY;
pub(crate) use outside_include::OUTSIDE_INCLUDE;
pub(crate) use unfit_value::UNFIT_VALUE;
pub(crate) use unknown_key::UNKNOWN_KEY;
pub(crate) use unknown_profile::UNKNOWN_PROFILE;
pub(crate) use unknown_reference::UNKNOWN_REFERENCE;
pub(crate) use unreadable_file::UNREADABLE_FILE;
pub(crate) use untyped_entry::UNTYPED_ENTRY;
pub(crate) use wrong_type::WRONG_TYPE;

use super::Rule;

/// Every fault, by name.
pub static ALL: &[&Rule] = &[
    &COLLIDING_AXES,
    &DUPLICATE_DEFINITION,
    &DUPLICATE_INDEX,
    &EXCEEDED_LIMIT,
    &FORBIDDEN_CHARACTER,
    &INCLUDE_CYCLE,
    &INVALID_TOML,
    &INVALID_VALUE,
    &MISQUOTED_ERRATUM,
    &MISSING_FILE,
    &MISSING_KEY,
    &OUTSIDE_INCLUDE,
    &UNFIT_VALUE,
    &UNKNOWN_KEY,
    &UNKNOWN_PROFILE,
    &UNKNOWN_REFERENCE,
    &UNREADABLE_FILE,
    &UNTYPED_ENTRY,
    &WRONG_TYPE,
];
