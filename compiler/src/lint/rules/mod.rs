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
    ambiguous_name,
    ambiguous_vendor_code,
    contradicted_count,
    contradicted_identity,
    contradicted_modes,
    contradicted_profile,
    contradicted_total,
    contradicted_width,
    deviating_access,
    deviating_mapping,
    deviating_type,
    empty_reason,
    excluded_assignment,
    hidden_command,
    idle_erratum,
    idle_mapped_entry,
    inverted_limits,
    manufacturer_bit,
    meaningful_reserved_bit,
    misaligned_entry,
    misclassified_error,
    misdirected_entry,
    misordered_sync_managers,
    missing_object,
    odd_count_type,
    overlapping_bits,
    overlapping_states,
    overlapping_sync_managers,
    oversized_pdo,
    patternless_state,
    placeholder_identity,
    repeated_error,
    repeated_mapping,
    reserved_index,
    subindex_gap,
    undefined_default,
    undersized_sync_manager,
    understated_axes,
    unexpected_mode_bit,
    unknown_rule,
    unmappable_entry,
    unmapped_mode,
    unreachable_default,
    unreachable_transition,
    unsized_string,
    unsupported_pdo_mode,
    unsupported_transition,
    withheld_bit,
}
