//! The rules: one file each, which stands here as a module and in the list.
//!
//! The modules are declared one by one, not by the macro, so that tools which read the code find them.

mod absent_mapped_entry;
mod ambiguous_choice;
mod ambiguous_name;
mod ambiguous_pattern;
mod ambiguous_pdo_name;
mod ambiguous_scaling;
mod ambiguous_value_name;
mod ambiguous_vendor_code;
mod blank_text;
pub(crate) mod channelless_value;
mod circular_trigger;
pub(crate) mod clashing_identifier;
mod code_in_range;
mod commanded_automatic_transition;
mod contradicted_activation;
mod contradicted_assignment;
mod contradicted_change;
pub(crate) mod contradicted_config_data;
mod contradicted_control;
mod contradicted_count;
mod contradicted_default;
mod contradicted_edge;
mod contradicted_group;
mod contradicted_identity;
mod contradicted_kind;
mod contradicted_modes;
mod contradicted_notation;
pub(crate) mod contradicted_period;
mod contradicted_placeholder;
mod contradicted_profile;
mod contradicted_quantity;
mod contradicted_role;
mod contradicted_severity;
mod contradicted_size;
mod contradicted_slots;
mod contradicted_sync_types;
mod contradicted_total;
mod contradicted_width;
mod deviating_access;
mod deviating_kind;
mod deviating_mapping;
mod deviating_pattern;
mod deviating_transition;
mod deviating_type;
mod differing_axis;
mod disguised_choice;
mod empty_limits;
pub(crate) mod empty_name;
mod empty_reason;
mod excluded_assignment;
pub(crate) mod foreign_protocol;
pub(crate) mod foreign_state;
mod hidden_command;
mod hollow_table;
mod idle_assumption;
mod idle_change;
mod idle_enumeration;
pub(super) mod idle_erratum;
mod idle_interlock;
mod idle_mapped_entry;
pub(super) mod idle_remark;
mod idle_timeout;
mod idle_unit;
mod idle_write_window;
mod ignored_transition;
pub(crate) mod impossible_boot_mailbox;
pub(crate) mod impossible_eeprom_size;
pub(crate) mod incomplete_timeouts;
mod indistinct_bit;
mod indistinct_choice;
pub(crate) mod indistinct_members;
mod inverted_limits;
mod malformed_url;
mod manufacturer_bit;
mod meaningful_reserved_bit;
mod misaligned_entry;
mod misclassified_error;
mod misdirected_entry;
mod misordered_sync_managers;
mod misplaced_pdo;
mod misplaced_sync_manager;
pub(crate) mod missing_config_data;
mod missing_group;
mod missing_mandatory_pdo;
mod missing_mode;
mod missing_object;
mod missing_sync_manager;
mod missing_transition;
mod misspelt_name;
mod misspelt_symbol;
pub(crate) mod mixed_vendors;
mod odd_count_type;
mod one_sided_exclusion;
mod opposed_switch;
mod overfull_assignment;
mod overlapping_areas;
mod overlapping_bits;
mod overlapping_bytes;
mod overlapping_groups;
mod overlapping_registers;
mod overlapping_states;
mod overlapping_sync_managers;
mod overlapping_values;
pub(crate) mod overlong_mode_code;
pub(crate) mod overlong_name;
pub(crate) mod overlong_pin;
mod overlong_shift;
pub(crate) mod overlong_value;
mod overruled_statement;
mod oversized_pdo;
pub(crate) mod oversized_write;
mod overstrict_pattern;
mod overwide_entry;
mod patternless_state;
pub(crate) mod pinless_value;
mod placeholder_identity;
mod pointless_exclusion;
mod portless_current;
mod refused_choice;
mod refused_step;
mod renamed_entry;
mod repeated_alias;
mod repeated_assignment;
mod repeated_change;
mod repeated_default;
mod repeated_error;
mod repeated_item;
mod repeated_limit;
mod repeated_mailbox;
mod repeated_mapping;
mod repeated_write;
pub(crate) mod replaced_revision;
mod reserved_index;
pub(crate) mod several_edges;
mod shared_number;
mod stray_profile_object;
mod subindex_gap;
pub(crate) mod surplus_sync_manager;
pub(crate) mod unaligned_value;
mod unassignable_pdo;
mod unassigned_mapping;
pub(crate) mod uncontrolled_axis;
pub(crate) mod uncopied_value;
mod undefined_default;
mod undefined_write;
pub(crate) mod undersized_eeprom;
mod undersized_sync_manager;
mod understated_axes;
pub(crate) mod uneven_slots;
mod unexpected_mode_bit;
pub(crate) mod unfit_image;
mod unknown_homing_method;
pub(super) mod unknown_rule;
pub(crate) mod unlike_slots;
mod unlistable_mode;
mod unlisted_document;
mod unlisted_vendor_code;
mod unmappable_entry;
mod unmapped_mode;
mod unmapped_set_value;
pub(super) mod unmended_erratum;
mod unnumbered_group;
mod unplaced_object;
mod unreachable_area;
mod unreachable_cycle_time;
mod unreachable_default;
mod unreachable_transition;
mod unreachable_value;
mod unrepresentable_cycle_time;
mod unrepresentable_value;
mod unrestorable_value;
mod unscalable_value;
mod unscaled_axis;
mod unsized_string;
pub(crate) mod unslotted_axis;
mod unsourced_fact;
pub(crate) mod unspellable_text;
pub(crate) mod unspoken_ability;
mod unsupported_configuration_mode;
mod unsupported_cycle_mode;
mod unsupported_cycle_time;
mod unsupported_pdo_mode;
mod unsupported_transition;
mod unwritable_output;
mod widthless_entry;
mod withheld_bit;

use super::Lint;

macro_rules! lints {
    ($($name:ident,)*) => {
        /// Every rule, by name.
        pub static ALL: &[Lint] = &[$(Lint { rule: &$name::RULE, check: $name::check }),*];
    };
}

lints! {
    absent_mapped_entry, ambiguous_choice, ambiguous_name, ambiguous_pattern, ambiguous_pdo_name,
    ambiguous_scaling, ambiguous_value_name, ambiguous_vendor_code, blank_text, channelless_value,
    circular_trigger, clashing_identifier, code_in_range, commanded_automatic_transition,
    contradicted_activation, contradicted_assignment, contradicted_change, contradicted_config_data,
    contradicted_control, contradicted_count, contradicted_default, contradicted_edge, contradicted_group,
    contradicted_identity, contradicted_kind, contradicted_modes, contradicted_notation, contradicted_period,
    contradicted_placeholder, contradicted_profile, contradicted_quantity, contradicted_role,
    contradicted_severity, contradicted_size, contradicted_slots, contradicted_sync_types, contradicted_total,
    contradicted_width, deviating_access, deviating_kind, deviating_mapping, deviating_pattern,
    deviating_transition, deviating_type, differing_axis, disguised_choice, empty_limits, empty_name,
    empty_reason, excluded_assignment, foreign_protocol, foreign_state, hidden_command, hollow_table,
    idle_assumption, idle_change, idle_enumeration, idle_erratum, idle_interlock, idle_mapped_entry,
    idle_remark, idle_timeout, idle_unit, idle_write_window, ignored_transition, impossible_boot_mailbox,
    impossible_eeprom_size, incomplete_timeouts, indistinct_bit, indistinct_choice, indistinct_members,
    inverted_limits, malformed_url, manufacturer_bit, meaningful_reserved_bit, misaligned_entry,
    misclassified_error, misdirected_entry, misordered_sync_managers, misplaced_pdo, misplaced_sync_manager,
    missing_config_data, missing_group, missing_mandatory_pdo, missing_mode, missing_object,
    missing_sync_manager, missing_transition, misspelt_name, misspelt_symbol, mixed_vendors, odd_count_type,
    one_sided_exclusion, opposed_switch, overfull_assignment, overlapping_areas, overlapping_bits,
    overlapping_bytes, overlapping_groups, overlapping_registers, overlapping_states,
    overlapping_sync_managers, overlapping_values, overlong_mode_code, overlong_name, overlong_pin,
    overlong_shift, overlong_value, overruled_statement, oversized_pdo, oversized_write, overstrict_pattern,
    overwide_entry, patternless_state, pinless_value, placeholder_identity, pointless_exclusion,
    portless_current, refused_choice, refused_step, renamed_entry, repeated_alias, repeated_assignment,
    repeated_change, repeated_default, repeated_error, repeated_item, repeated_limit, repeated_mailbox,
    repeated_mapping, repeated_write, replaced_revision, reserved_index, several_edges, shared_number,
    stray_profile_object, subindex_gap, surplus_sync_manager, unaligned_value, unassignable_pdo,
    unassigned_mapping, uncontrolled_axis, uncopied_value, undefined_default, undefined_write,
    undersized_eeprom, undersized_sync_manager, understated_axes, uneven_slots, unexpected_mode_bit,
    unfit_image, unknown_homing_method, unknown_rule, unlike_slots, unlistable_mode, unlisted_document,
    unlisted_vendor_code, unmappable_entry, unmapped_mode, unmapped_set_value, unmended_erratum,
    unnumbered_group, unplaced_object, unreachable_area, unreachable_cycle_time, unreachable_default,
    unreachable_transition, unreachable_value, unrepresentable_cycle_time, unrepresentable_value,
    unrestorable_value, unscalable_value, unscaled_axis, unsized_string, unslotted_axis, unsourced_fact,
    unspellable_text, unspoken_ability, unsupported_configuration_mode, unsupported_cycle_mode,
    unsupported_cycle_time, unsupported_pdo_mode, unsupported_transition, unwritable_output, widthless_entry,
    withheld_bit,
}
