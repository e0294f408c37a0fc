//! What values say to people.

use devc_runtime::bytes::WrongLength;
use devc_runtime::cia402::{Cause, Events, State, StateSet, Step, UnknownState};
use devc_runtime::coe::{Failure, Malformed, Protocol};
use devc_runtime::sdo::{AbortCode, DataType};
use devc_runtime::unit::Length;

#[test]
fn a_step_names_what_it_comes_of() {
    let step = |cause| Step { number: 9, from: State::OperationEnabled, to: State::SwitchOnDisabled, cause };
    let said = |cause| step(cause).to_string();
    let way = "transition 9, operation enabled to switch on disabled, by ";
    assert_eq!(said(Cause::Command("Disable voltage")), format!("{way}Disable voltage"));
    assert_eq!(said(Cause::Events(Events::FAULT | Events::LOCKED_OUT)), format!("{way}fault, locked out"));
    let refused = said(Cause::Refused { controlword: 0x001F });
    assert_eq!(refused, format!("{way}controlword 0x001F, not allowed here"));
    assert_eq!(Events::NONE.to_string(), "none");
}

#[test]
fn states_are_listed_in_the_order_of_the_profile() {
    let [ready, enabled] = [State::ReadyToSwitchOn, State::OperationEnabled];
    let both = StateSet::NONE.with(enabled).with(ready);
    assert_eq!(both.to_string(), "ready to switch on, operation enabled");
    assert_eq!(both.common(StateSet::NONE.with(ready).with(State::Fault)).to_string(), "ready to switch on");
    assert_eq!(StateSet::NONE.to_string(), "none");
    let unknown = |candidates| UnknownState { statusword: 0x0A5, candidates }.to_string();
    assert_eq!(unknown(StateSet::NONE), "statusword 0x00A5 fits no state");
    assert_eq!(unknown(both), "statusword 0x00A5 fits several states: ready to switch on, operation enabled");
}

#[test]
fn what_goes_wrong_with_a_transfer_is_told() {
    let wrong = WrongLength { expected: 4, found: 2 };
    assert_eq!(wrong.to_string(), "expected 4 bytes, found 2");
    let abort = AbortCode::NO_SUCH_OBJECT;
    for (failure, said) in [
        (Failure::Aborted(abort), abort.to_string()),
        (Failure::Unexpected, "the answer is not one to the request".to_owned()),
        (Failure::TooLong, "the value is longer than expected".to_owned()),
        (Failure::Malformed(Malformed::TooShort), "the message ends too early".to_owned()),
        (
            Failure::Malformed(Malformed::OtherProtocol(Protocol(4))),
            "expected protocol 3 (CoE), found 4".to_owned(),
        ),
        (Failure::Malformed(Malformed::UnknownCommand(0xA0)), "unknown command 0xA0".to_owned()),
    ] {
        assert_eq!(failure.to_string(), said);
    }
    // ETG.1000.6, SDO abort codes; CiA 301, data types
    assert!(abort.to_string().starts_with("0x06020000: "), "{abort}");
    assert_eq!(AbortCode(0x1234).to_string(), "0x00001234: unknown abort code");
    assert_eq!(
        (DataType(0x0007).to_string(), DataType(0x1234).to_string()),
        ("UNSIGNED32".into(), "0x1234".into())
    );
}

#[test]
fn nothing_of_a_quantity_has_no_sign() {
    for (micrometres, said) in [(0, "0 m"), (-1, "-0.000001 m"), (1_000_000, "1 m")] {
        assert_eq!(Length::micrometres(micrometres).to_string(), said);
    }
}
