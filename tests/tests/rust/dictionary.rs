//! The dictionary of the C-887 against the manual's table of objects.

use std::collections::BTreeSet;

use devc_generated::c887::dictionary::{Dictionary, TABLE};
use devc_generated::c887::{Axis, Controlword, ErrorCode, HexapodState, STATES, Statusword, objects};
use devc_runtime::cia402::State;
use devc_runtime::error::ErrorCode as _;
use devc_runtime::object::Address;
use devc_runtime::sdo::{Access, DataType};
use devc_tests::manual::c887::{self as manual, Object};
use devc_tests::manual::{self as cells, Sub, rows};

/// The rows of the manual, with the address of each; not those that stand for a whole range, where the standard
/// leaves gaps.
fn listed() -> Vec<(Address, Object)> {
    let rows = rows::<Object>().expect("the table is whole").into_iter();
    rows.filter_map(|row| Some((Address::new(row.index, subindex(row.sub)?), row))).collect()
}

fn subindex(sub: Sub) -> Option<u8> {
    match sub {
        Sub::Variable => Some(0),
        Sub::One(subindex) => Some(subindex),
        Sub::Range(..) => None,
    }
}

#[test]
fn the_table_has_every_entry_of_the_manual() {
    for (address, row) in listed() {
        let found = TABLE.find(address).unwrap_or_else(|error| panic!("{address}: {error}"));
        let is_written = found.entry.access.0 & Access::WRITE.0 != 0;
        if let Some(access) = row.access {
            assert_eq!(is_written, access == cells::Access::ReadWrite, "{address}");
        }
        if row.writing == "P->S" {
            assert!(!found.entry.access.includes(Access::WRITE), "{address}");
            assert!(found.entry.access.includes(Access::WRITE_PRE_OPERATIONAL), "{address}");
        }
        // An erratum answers the printed INT32: the highest subindex is a UINT8.
        let is_misprinted = address == Address::new(0x5010, 0);
        if let Some(expected) = data_type(row.data_type).filter(|_| !is_misprinted) {
            assert_eq!(found.entry.data_type, expected, "{address}");
        }
    }
}

fn data_type(name: &str) -> Option<DataType> {
    match name {
        "UINT8" => Some(DataType::UNSIGNED8),
        "UINT16" => Some(DataType::UNSIGNED16),
        "UINT32" | "UNINT32" => Some(DataType::UNSIGNED32),
        "INT8" => Some(DataType::INTEGER8),
        "INT32" => Some(DataType::INTEGER32),
        "STRING" => Some(DataType::VISIBLE_STRING),
        _ => None,
    }
}

#[test]
fn every_value_has_a_place_of_its_own() {
    let mut places = BTreeSet::new();
    for (index, object) in TABLE.objects() {
        for entry in object.entries {
            let found = TABLE.find(Address::new(index, entry.subindex)).expect("it was listed");
            match found.place() {
                Some(place) => assert!(places.insert(place), "0x{index:04X}:{:02X}", entry.subindex),
                None => assert!(TABLE.constant(found).is_some(), "0x{index:04X}:{:02X}", entry.subindex),
            }
        }
    }
    let axes: Vec<_> = (0..6).map(|axis| places.iter().filter(|place| place.axis == axis).count()).collect();
    assert!(axes[1..].iter().all(|count| *count > 0 && *count == axes[1]), "{axes:?}");
}

#[test]
fn defaults_are_those_of_the_manual() {
    let device = Dictionary::DEFAULT;
    let printed = |index, subindex| {
        let found = listed().into_iter().find(|(address, _)| *address == Address::new(index, subindex));
        found.and_then(|(_, row)| row.default()).unwrap_or_else(|| panic!("0x{index:04X}:{subindex:02X}"))
    };
    assert_eq!(i64::from(device.device_type), printed(0x1000, 0));
    assert_eq!(i64::from(device.identity_object.vendor_id), printed(0x1018, 1));
    assert_eq!(i64::from(device.identity_object.serial_number), printed(0x1018, 4));
    assert_eq!(device.manufacturer_device_name, "C-887 EtherCAT");
    assert_eq!(i64::from(device.sync_manager_2_pdo_assignment.items[5]), printed(0x1C12, 6));
    assert_eq!(i64::from(device.sync_manager_2_pdo_assignment.count), printed(0x1C12, 0));
    // An erratum answers the printed 2: entries 1 to 4 are listed.
    assert_eq!(device.buffered_parameters.highest_subindex_supported, 4);
    for (axis, shift) in device.axes.iter().zip((0_u16..).step_by(0x800)) {
        assert_eq!(i64::from(axis.position_factor[1]), printed(0x6093 + shift, 2));
        let time = axis.interpolation_time_period;
        assert_eq!(i64::from(time.interpolation_time_period_value), printed(0x60C2 + shift, 1));
        assert_eq!(i64::from(time.interpolation_time_index), printed(0x60C2 + shift, 2));
        assert_eq!(i64::from(axis.controlword.0), printed(0x6040 + shift, 0));
        assert_eq!(i64::from(axis.homing_method), printed(0x6098 + shift, 0));
    }
}

#[test]
fn typed_entries_are_in_the_table() {
    for axis in Axis::ALL {
        let limit = objects::software_position_limit::max_position_limit(axis);
        let found = TABLE.find(limit.address()).expect("it is in the dictionary");
        assert!(found.entry.access.includes(limit.access()));
    }
    assert_eq!(objects::debug_information::HEXAPOD_STATE.decode(&[9, 0, 0, 0]), Ok(HexapodState(9)));
    assert_eq!((HexapodState::FAULT.name(), HexapodState(9).name()), (Some("fault"), None));
}

#[test]
fn words_states_and_errors_speak() {
    assert_eq!(Statusword(0x0037).state(), Ok(State::OperationEnabled));
    assert_eq!(STATES.encode(State::Fault), Some(0x0008));
    let word = Controlword(0).with_switch_on(true).with_fault_reset(true);
    assert_eq!((word.0, word.switch_on(), word.with_switch_on(false).0), (0x0081, true, 0x0080));
    assert!(Statusword(1 << 12).hm_homing_attained());
    // the table of states (p. 9), bits 4 and 7 (p. 12)
    assert_eq!(Statusword(0x00B7).to_string(), "operation enabled, voltage enabled, warning");
    assert_eq!(Statusword(0x0001).to_string(), "ready to switch on", "no state has this pattern");
    assert_eq!(Controlword(0x0007).to_string(), "switch on, enable voltage, quick stop");
    assert_eq!(ErrorCode(0x7121).to_string(), "0x7121: Motor Blocked");
    assert_eq!(ErrorCode(0xFF77).name(), Some("Manufacturer-specific Error Codes"));
    assert_eq!(
        rows::<manual::ErrorCode>().expect("whole").iter().filter(|row| row.first == row.last).count(),
        ErrorCode::TABLE.len()
    );
}
