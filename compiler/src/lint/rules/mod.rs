//! The list of rules: one line and one file each.

use super::Lint;

macro_rules! lints {
    ($($name:ident,)*) => {
        $(pub(super) mod $name;)*

        /// Every rule, by name.
        pub static ALL: &[Lint] = &[$(Lint { rule: &$name::RULE, check: $name::check }),*];
    };
}

lints! {
    absent_mapped_entry,
    ambiguous_vendor_code,
    contradicted_count,
    contradicted_identity,
    contradicted_modes,
    contradicted_profile,
    deviating_access,
    deviating_mapping,
    deviating_type,
    idle_erratum,
    idle_mapped_entry,
    manufacturer_bit,
    misclassified_error,
    odd_count_type,
    placeholder_identity,
    undefined_default,
    understated_axes,
    unknown_rule,
    unsized_string,
    unsupported_pdo_mode,
    unsupported_transition,
    withheld_bit,
}
