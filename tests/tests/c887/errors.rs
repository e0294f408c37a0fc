//! Error codes, the error register and GCS codes against pages 18 to 20.

use std::collections::BTreeSet;

use devc_tests::manual::c887;

use crate::{device, rows};

#[test]
fn error_codes_are_those_of_the_manual() {
    let rows = rows::<c887::ErrorCode>();
    let printed: BTreeSet<_> = rows
        .iter()
        .map(|row| {
            let gcs: Vec<u32> = row.gcs.iter().map(|code| u32::from(*code)).collect();
            (row.first, row.last, row.name, gcs, row.register)
        })
        .collect();
    let described: BTreeSet<_> = device()
        .errors
        .iter()
        .map(|error| {
            (error.code, error.last, error.name.as_str(), error.vendor_codes.clone(), error.register)
        })
        .collect();
    assert_eq!(described, printed);
    assert_eq!(device().errors.iter().filter(|error| !error.is_range()).count(), 33);
}

#[test]
fn remarks_on_error_codes_are_kept() {
    for row in rows::<c887::ErrorCode>().into_iter().filter(|row| row.remark) {
        let error = device().errors.iter().find(|error| error.code == row.first && !error.is_range());
        assert!(error.is_some_and(|error| error.about.is_some()), "0x{:04X} has a remark", row.first);
    }
}

#[test]
fn the_error_register_has_the_bits_of_the_manual() {
    let word = device().word("error-register").expect("it is described");
    for row in rows::<c887::ErrorRegisterBit>() {
        let field = word.fields.iter().find(|field| (field.low..=field.high).contains(&row.bit));
        let field = field.unwrap_or_else(|| panic!("bit {} is not described", row.bit));
        assert_eq!(field.reserved, row.name.starts_with("Reserved"), "bit {}", row.bit);
    }
}

#[test]
fn gcs_codes_are_those_of_the_manual() {
    let printed: Vec<_> =
        rows::<c887::GcsCode>().into_iter().map(|row| (u32::from(row.code), row.name)).collect();
    let described: Vec<_> =
        device().vendor_codes.iter().map(|code| (code.code, code.name.as_str())).collect();
    assert_eq!(described, printed);
}
