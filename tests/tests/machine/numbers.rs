//! Numbers with names in the generated modules, against the tables of the manuals: what a table names is found, what it
//! does not name stays the number that came.

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::cia402::{Direction, HomingMethod, Mode, State, UnknownMode, homing_method};
use devc_runtime::error::ErrorCode;
use devc_tests::manual::{self, ErrorKind};

use crate::described::{plain, rows};

#[test]
fn homing_methods_are_those_of_the_table_and_no_others() {
    use pmc_sc6::double::HomingMethod as Method;
    let printed = rows::<manual::pmc_sc6::Homing>();
    for number in i8::MIN..=i8::MAX {
        let method = Method(number);
        let Some(row) = printed.iter().find(|row| row.codes.contains(&number)) else {
            assert_eq!(method.info(), None);
            assert_eq!(method.to_string(), format!("{number}: unknown homing method"));
            continue;
        };
        let info = method.info().expect("the manual has it");
        let direction = match row.direction {
            "Positive" => Some(Direction::Positive),
            "Negative" => Some(Direction::Negative),
            _ => None,
        };
        assert_eq!((info.number, info.name), (number, row.name));
        assert_eq!((info.direction, info.pulse), (direction, row.zero_pulse), "method {number}");
        assert_eq!(plain(info.target), plain(row.feature), "method {number}");
        assert!(!info.text.is_empty(), "the manual has a chapter on each method");
        assert_eq!(homing_method(method).to_string(), format!("{number}: {}", row.name));
    }
}

#[test]
fn modes_are_those_of_the_tables_and_others_keep_their_number() {
    let pilz = rows::<manual::pmc_sc6::Mode>();
    let pi = rows::<manual::c887::Mode>();
    let kollmorgen = rows::<manual::s700::Mode>();
    for code in i8::MIN..=i8::MAX {
        let shown = pmc_sc6::double::ModeOfOperation::decode(code);
        let has = pilz.iter().any(|row| row.code == code);
        assert_eq!(shown.map(|mode| (mode.code(), mode.to_string().is_empty())), answer(has, code));
        let shown = c887::ModeOfOperation::decode(code);
        let has = pi.iter().any(|row| row.code.cast_signed() == code);
        assert_eq!(shown.map(|mode| (mode.code(), mode.text().is_empty())), answer(has, code));
        // each mode of the S700 has a second number
        let row = kollmorgen.iter().find(|row| [row.code, row.vendor].map(u8::cast_signed).contains(&code));
        let shown = s700::s700::ModeOfOperation::decode(code).map(|mode| mode.code());
        assert_eq!(shown, row.map(|row| row.code.cast_signed()).ok_or(UnknownMode(code)));
    }
}

/// What a device says to a number: the mode of that number, which has a text, or that it is not known.
fn answer(has: bool, code: i8) -> Result<(i8, bool), UnknownMode> {
    if has { Ok((code, false)) } else { Err(UnknownMode(code)) }
}

#[test]
fn al_status_codes_are_those_of_the_table() {
    use s700::s700::AlStatusCode;
    let printed = rows::<manual::s700::AlCode>();
    for code in 0..=u16::MAX {
        let name = AlStatusCode(code).name();
        let row = printed.iter().find(|row| row.code == code);
        assert_eq!(name.map(plain), row.map(|row| plain(row.name)), "0x{code:04X}");
    }
    assert_eq!(AlStatusCode(0x001B).to_string(), "0x001B: unknown");
    let shown = AlStatusCode::INVALID_REQUESTED_STATE_CHANGE.to_string();
    assert_eq!(shown, "0x0011: Invalid requested state change");
}

#[test]
fn errors_have_register_and_vendor_codes_of_the_table() {
    for row in rows::<manual::c887::ErrorCode>() {
        let error = c887::ErrorCode(row.first);
        assert_eq!(error.name().map(plain), Some(plain(row.name)), "0x{:04X}", row.first);
        if row.kind == ErrorKind::Code {
            let info = error.info().expect("a single code is in the table");
            let printed: Vec<u32> = row.gcs.iter().map(|code| u32::from(*code)).collect();
            assert_eq!((info.register, info.vendor_codes), (row.register, &*printed), "0x{:04X}", row.first);
        }
    }
    let named = |code: &u16| c887::ErrorCode(*code).name().is_some();
    let unknown = (0..=u16::MAX).find(|code| !named(code)).expect("not every number is an error");
    assert_eq!(c887::ErrorCode(unknown).to_string(), format!("0x{unknown:04X}: unknown error"));
}

#[test]
fn causes_of_events_are_those_of_the_manual() {
    use pmc_sc6::double::VendorCode;
    let printed = rows::<manual::pmc_sc6::Cause>();
    for number in 0..1000 {
        let event = VendorCode(number);
        let place = format!("event {number}");
        for cause in 0..100_u16 {
            let row =
                printed.iter().find(|row| row.place == place && i64::from(row.code) == i64::from(cause));
            assert_eq!(event.cause(cause.into()).is_some(), row.is_some(), "{place}, cause {cause}");
        }
    }
}

#[test]
fn each_state_has_a_text() {
    for state in State::ALL {
        let texts =
            [c887::state_text(state), s700::s700::state_text(state), pmc_sc6::double::state_text(state)];
        assert!(texts.iter().all(|text| !text.is_empty()), "{state}: {texts:?}");
    }
    // 3.4.1 of the EtherCAT manual: the amplifier brakes on a ramp of its own
    assert!(s700::s700::state_text(State::QuickStopActive).contains("quick stop ramp"));
}
