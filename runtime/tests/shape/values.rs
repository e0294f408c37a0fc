//! What small values answer, by the standards that define them.

use devc_runtime::bytes::WrongLength;
use devc_runtime::cia402::{Direction, Edge, ModeStep, ModeSwitch, Modes, Pattern, Refusal, Running, State};
use devc_runtime::cia402::{StateSet, generic};
use devc_runtime::coe::{Emergency, Envelope, MailboxError, Malformed, Protocol, Service};
use devc_runtime::esm::{Clocked, Configured};
use devc_runtime::object::{Address, Int, Uint, Value};
use devc_runtime::sdo::{AbortCode, DataType};
use devc_runtime::start_up::Write;
use devc_runtime::unit::{Length, Unfit, Unit};

enum Device {}

const HUNDREDTHS: Unit<Device, Length> = Unit::of::<10_000, 1>();

/// CiA 402, state coding; the last three are none of a state.
#[test]
fn patterns_overlap_where_a_word_matches_both() {
    let patterns = [
        (0x4F, 0x00),
        (0x4F, 0x40),
        (0x6F, 0x21),
        (0x6F, 0x23),
        (0x6F, 0x27),
        (0x6F, 0x07),
        (0x4F, 0x0F),
        (0x4F, 0x08),
        (0, 0),
        (6, 2),
        (3, 1),
    ]
    .map(|(mask, value)| Pattern { mask, value });
    for one in &patterns {
        for other in &patterns {
            let is_shared = (0..=u16::MAX).any(|word| one.matches(word) && other.matches(word));
            assert_eq!(one.overlaps(*other), is_shared, "{one} and {other}");
        }
    }
}

/// S700, 3.4.2: P and N.
#[test]
fn an_edge_is_one_of_its_bit_alone() {
    for (previous, current) in (0..16).flat_map(|previous| (0..16).map(move |current| (previous, current))) {
        let (was, is) = (previous & 4 != 0, current & 4 != 0);
        assert_eq!(Edge::Rising(4).happened(previous, current), !was && is);
        assert_eq!(Edge::Falling(4).happened(previous, current), was && !is);
        assert_eq!(Edge::Rising(4).before(current) & 4, 0);
        assert_eq!(Edge::Falling(4).before(current), current | 4);
    }
}

#[test]
fn a_set_of_states_has_what_is_put_in_and_not_taken_out() {
    let set = StateSet::of(&[State::Fault, State::SwitchedOn]);
    assert_eq!(set.and(StateSet::of(&[State::Fault])), set);
    assert_eq!(set.without(State::Fault), StateSet::of(&[State::SwitchedOn]));
    assert_eq!(set.without(State::OperationEnabled), set);
    assert_eq!(format!("{:?}", set.without(State::Fault)), "{SwitchedOn}");
}

#[test]
fn a_mode_that_is_refused_is_no_mode_or_the_one_before() {
    let strict = Modes { refusal: Refusal::Fault, ..generic::MODES };
    let strict: &'static Modes = Box::leak(Box::new(strict));
    for (modes, step, display) in
        [(&generic::MODES, ModeStep::Ignored { asked: 77 }, 8), (strict, ModeStep::Failed { asked: 77 }, 0)]
    {
        let mut mode = ModeSwitch::new(modes);
        mode.cycle(8, State::SwitchedOn, Running::Over);
        assert_eq!(mode.display(), 8);
        assert_eq!(mode.cycle(77, State::SwitchedOn, Running::Over), step);
        assert_eq!(mode.display(), display);
        mode.clear();
        assert_eq!(mode.display(), 0);
    }
}

/// ETG.1000.6, CoE header: the service is in the upper four bits of the second byte, whatever the envelope was for.
#[test]
fn an_emergency_is_sent_as_one() {
    let mut frame = [0; 16];
    let emergency = Emergency { code: 0x7121, register: 0x21, data: [0; 5] };
    assert_eq!(emergency.encode(Envelope::new(Service::SDO_RESPONSE), &mut frame), Ok(16));
    assert_eq!(frame[7], 0x10);
}

/// ETG.1000.4, mailbox error reply: the code for each way in which a message can be wrong.
#[test]
fn what_is_wrong_with_a_message_has_a_code_and_a_text_of_its_own() {
    let all = [
        (Malformed::TooShort, MailboxError(6), "ends too early"),
        (Malformed::WrongLength, MailboxError(8), "length"),
        (Malformed::OtherProtocol(Protocol::FOE), MailboxError(2), "4"),
        (Malformed::UnknownCommand(0xE0), MailboxError(4), "0xE0"),
        (Malformed::NoRoom, MailboxError(8), "fit"),
    ];
    for (malformed, code, text) in all {
        assert_eq!(MailboxError::from(malformed), code);
        assert!(malformed.to_string().contains(text), "{malformed}");
    }
}

/// ETG.1000.4, registers of a sync manager: bit 0 of the activation, bit 6 of the control byte.
#[test]
fn a_sync_manager_is_on_and_watched_by_one_bit_each() {
    let registers =
        |control: u8, activate: u8| Configured::from_registers([0, 0x10, 0x80, 0, control, 0, activate, 0]);
    assert!(registers(0x24, 0x01).is_on);
    assert!(registers(0x24, 0xFF).is_on);
    assert!(!registers(0x24, 0xFE).is_on);
    assert_eq!((registers(0x24, 1).address, registers(0x24, 1).length), (0x1000, 0x80));
}

/// ETG.1000.4, distributed clock: bits 0 to 2 of 0x0981.
#[test]
fn a_signal_is_made_if_its_bit_and_the_unit_are_on() {
    for activation in 0..16 {
        let clocked = Clocked { activation, sync0_ns: 1, sync1_ns: 0 };
        let is_on = |bit: u8| activation >> bit & 1 == 1;
        assert_eq!(clocked.is_on(), is_on(0));
        assert_eq!(clocked.has_sync0(), is_on(0) && is_on(1));
        assert_eq!(clocked.has_sync1(), is_on(0) && is_on(2));
    }
}

/// ETG.1020, base data types, and which of them have a sign.
#[test]
fn widths_are_the_types_of_the_standard() {
    let types = [
        (Int::<24, 3>::DATA_TYPE, 0x10),
        (Int::<40, 5>::DATA_TYPE, 0x12),
        (Int::<48, 6>::DATA_TYPE, 0x13),
        (Int::<56, 7>::DATA_TYPE, 0x14),
        (Uint::<24, 3>::DATA_TYPE, 0x16),
        (Uint::<40, 5>::DATA_TYPE, 0x18),
        (Uint::<48, 6>::DATA_TYPE, 0x19),
        (Uint::<56, 7>::DATA_TYPE, 0x1A),
        (Uint::<1, 1>::DATA_TYPE, 0x30),
        (Uint::<7, 1>::DATA_TYPE, 0x36),
    ];
    for (data_type, number) in types {
        assert_eq!(data_type, DataType(number));
        assert_eq!(data_type.is_signed(), number < 0x16);
    }
    let signed = (0..=0x36).filter(|number| DataType(*number).is_signed());
    assert!(signed.eq([2, 3, 4, 0x10, 0x12, 0x13, 0x14, 0x15]));
}

#[test]
fn numbers_of_odd_widths_are_scaled_as_others_are() {
    for number in [-300, -1, 0, 1, 2, 300] {
        let raw = Int::<24, 3>::new(number).unwrap();
        assert_eq!(HUNDREDTHS.physical(raw), HUNDREDTHS.physical(number as i32));
    }
    for number in [0, 1, 2, 300] {
        let raw = Uint::<24, 3>::new(number).unwrap();
        assert_eq!(HUNDREDTHS.physical(raw), HUNDREDTHS.physical(number as i32));
    }
}

#[test]
fn what_is_the_same_is_equal_and_shown() {
    const OTHER: Unit<Device, Length> = Unit::of::<1, 1>();
    assert!(HUNDREDTHS == HUNDREDTHS && HUNDREDTHS != OTHER);
    assert_ne!(Unfit::Inexact.to_string(), Unfit::OutOfRange.to_string());
    assert_eq!(
        (Direction::Positive.to_string(), Direction::Negative.name()),
        ("positive".to_owned(), "negative")
    );
    let write = Write::new(Address::new(0x60C2, 1), &[2, 1], "");
    assert!(write.to_string().starts_with("0x60C2:01 = 0x0102"), "{write}");
}

/// CiA 301, SDO abort codes.
#[test]
fn a_length_is_too_high_or_too_low() {
    assert_eq!(AbortCode::from(WrongLength { expected: 4, found: 5 }).0, 0x0607_0012);
    assert_eq!(AbortCode::from(WrongLength { expected: 4, found: 3 }).0, 0x0607_0013);
}
