//! A device that answers requests about its dictionary.

use devc_runtime::coe::{Emergency, Mailbox, Request};
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::{Operational, PreOperational};
use devc_runtime::sdo::{AbortCode, Server};

use crate::device::{GAIN, LIST, MIXED, MODEL, NAME, NOTE, RATIO, SECRET, Tiny, WIDE};
use crate::master::{Master, raw};

/// A mailbox that can take values of 16 bytes in segments.
fn mailbox() -> Mailbox<Tiny, (), 16> {
    Mailbox::new(Server::new(Tiny::NEW, ()))
}

const MASTER: Master = Master { size: 16, state: PreOperational, is_complete: false };
const SIZES: [usize; 6] = [16, 17, 20, 24, 31, 128];

#[test]
fn values_of_any_length_come_through_mailboxes_of_any_size() {
    let values = [
        (NAME, b"tiny".to_vec()),
        (GAIN, vec![5, 0]),
        (MODEL, b"model 1".to_vec()),
        (WIDE, vec![1, 2, 3]),
        (RATIO, 1.5_f32.to_le_bytes().to_vec()),
    ];
    for size in SIZES {
        let (master, mut mailbox) = (Master { size, ..MASTER }, mailbox());
        for (address, value) in &values {
            assert_eq!(master.upload(&mut mailbox, *address).as_ref(), Ok(value), "{address}, {size} bytes");
        }
    }
}

#[test]
fn a_long_text_needs_several_segments() {
    let text = "a name of sixty-four characters, which takes a few more messages";
    assert_eq!(text.len(), 64);
    for size in SIZES {
        let mut mailbox = mailbox();
        mailbox.server.values.name = text;
        let master = Master { size, ..MASTER };
        // the entry has room for ten
        assert_eq!(master.upload(&mut mailbox, NAME), Ok(text.as_bytes()[..10].to_vec()), "{size} bytes");
    }
}

#[test]
fn values_are_written_at_once_or_in_segments() {
    for size in SIZES {
        let (master, mut mailbox) = (Master { size, ..MASTER }, mailbox());
        for text in ["", "a", "abcd", "abcde", "abcdefg", "abcdefgh"] {
            assert_eq!(master.download(&mut mailbox, NOTE, text.as_bytes()), Ok(()), "{text}, {size} bytes");
            assert_eq!(master.upload(&mut mailbox, NOTE), Ok(text.as_bytes().to_vec()));
        }
        assert_eq!(master.download(&mut mailbox, NOTE, b"abcdefghi"), Err(AbortCode::LENGTH_TOO_HIGH));
    }
}

#[test]
fn whole_objects_are_read_and_written() {
    for size in SIZES {
        let (master, mut mailbox) = (Master { size, is_complete: true, ..MASTER }, mailbox());
        let from = Address::new(MIXED, 0);
        let whole = vec![4, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0x34, 0x12, 0, 0];
        assert_eq!(master.upload(&mut mailbox, from), Ok(whole), "{size} bytes");
        let whole = [3, 0, 7, 0, 8, 0, 9, 0];
        assert_eq!(master.download(&mut mailbox, Address::new(LIST, 0), &whole), Ok(()), "{size} bytes");
        assert_eq!(mailbox.server.values.list, [7, 8, 9]);
    }
}

#[test]
fn refusals_are_aborts() {
    let mut mailbox = mailbox();
    let operational = Master { state: Operational, ..MASTER };
    assert_eq!(MASTER.upload(&mut mailbox, SECRET), Err(AbortCode::WRITE_ONLY));
    assert_eq!(MASTER.upload(&mut mailbox, Address::new(0x2FFF, 0)), Err(AbortCode::NO_SUCH_OBJECT));
    assert_eq!(MASTER.upload(&mut mailbox, Address::new(LIST, 9)), Err(AbortCode::NO_SUCH_SUBINDEX));
    assert_eq!(MASTER.download(&mut mailbox, NAME, b"new"), Err(AbortCode::READ_ONLY));
    assert_eq!(operational.download(&mut mailbox, GAIN, &[1, 0]), Err(AbortCode::DEVICE_STATE));
    assert_eq!(MASTER.download(&mut mailbox, GAIN, &[1]), Err(AbortCode::LENGTH_TOO_LOW));
    assert_eq!(MASTER.download(&mut mailbox, GAIN, &[0xFF, 0x7F]), Err(AbortCode::VALUE_TOO_HIGH));
    let mut without_buffer: Mailbox<Tiny> = Mailbox::new(Server::new(Tiny::NEW, ()));
    assert_eq!(MASTER.download(&mut without_buffer, NOTE, b"longer"), Err(AbortCode::OUT_OF_MEMORY));
    assert_eq!(without_buffer.server.values, Tiny::NEW);
}

/// The abort code at the end of an answer.
fn aborted(answer: &[u8]) -> AbortCode {
    assert_eq!((answer.len(), answer[7], answer[8]), (16, 0x20, 0x80), "{answer:02X?}");
    AbortCode(u32::from_le_bytes(answer[12..].try_into().unwrap()))
}

#[test]
fn segments_have_to_come_in_turn() {
    let mut mailbox = mailbox();
    let segment = |toggle, is_last, data| Request::DownloadSegment { toggle, is_last, data };
    let begin = |size| Request::Download { address: NOTE, is_complete: false, size: Some(size), data: &[] };
    // nothing is under way
    for stray in [segment(false, true, b"abc".as_slice()), Request::UploadSegment { toggle: false }] {
        assert_eq!(aborted(&raw(&mut mailbox, stray).unwrap()), AbortCode::UNKNOWN_COMMAND_SPECIFIER);
    }
    raw(&mut mailbox, begin(8)).unwrap();
    let wrong = raw(&mut mailbox, segment(true, false, b"abcd")).unwrap();
    assert_eq!(aborted(&wrong), AbortCode::TOGGLE_BIT_NOT_ALTERNATED);
    // which ended the transfer
    let late = raw(&mut mailbox, segment(false, true, b"abcdefgh")).unwrap();
    assert_eq!(aborted(&late), AbortCode::UNKNOWN_COMMAND_SPECIFIER);
    raw(&mut mailbox, begin(8)).unwrap();
    let short = raw(&mut mailbox, segment(false, true, b"abcdefg")).unwrap();
    assert_eq!(aborted(&short), AbortCode::LENGTH_TOO_LOW);
    raw(&mut mailbox, begin(5)).unwrap();
    let long = raw(&mut mailbox, segment(false, true, b"abcdef")).unwrap();
    assert_eq!(aborted(&long), AbortCode::LENGTH_TOO_HIGH);
    assert_eq!(mailbox.server.values, Tiny::NEW);
}

/// ETG.1000.6, SDO download: what cannot be written is refused before the data comes, which may take many segments.
#[test]
fn a_long_value_is_refused_before_it_comes() {
    let begin = |address, size| {
        let request = Request::Download { address, is_complete: false, size: Some(size), data: &[] };
        raw(&mut mailbox(), request).unwrap()
    };
    assert_eq!(aborted(&begin(NOTE, 9)), AbortCode::LENGTH_TOO_HIGH);
    assert_eq!(aborted(&begin(NAME, 8)), AbortCode::READ_ONLY);
    assert_eq!(aborted(&begin(Address::new(0x2FFF, 0), 8)), AbortCode::NO_SUCH_OBJECT);
    assert_eq!(begin(NOTE, 8)[8], 0x60, "it is waited for");
}

#[test]
fn a_master_may_give_up() {
    let mut mailbox = mailbox();
    raw(&mut mailbox, Request::Upload { address: MODEL, is_complete: false }).unwrap();
    let abort = Request::Abort { address: MODEL, code: AbortCode::TIMEOUT };
    assert_eq!(raw(&mut mailbox, abort), Ok(vec![]));
    let segment = raw(&mut mailbox, Request::UploadSegment { toggle: false }).unwrap();
    assert_eq!(aborted(&segment), AbortCode::UNKNOWN_COMMAND_SPECIFIER);
}

#[test]
fn a_value_may_come_without_its_length() {
    let mut mailbox = mailbox();
    let request =
        Request::Download { address: GAIN, is_complete: false, size: None, data: &[9, 0, 0xAA, 0xAA] };
    let answer = raw(&mut mailbox, request).unwrap();
    assert_eq!(answer[8..], [0x60, 0x01, 0x20, 0, 0, 0, 0, 0]);
    assert_eq!(mailbox.server.values.gain, 9);
}

#[test]
fn a_message_that_comes_again_is_not_carried_out_again() {
    let mut mailbox = mailbox();
    let write = |mailbox: &mut Mailbox<Tiny, (), 16>, counter: u8, value: u8| {
        let message = [10, 0, 0, 0, 0, counter << 4 | 3, 0, 0x20, 0x2B, 1, 0x20, 0, value, 0, 0, 0];
        let length = mailbox.answer(&message, PreOperational, &mut [0; 16]);
        (length, mailbox.server.values.gain)
    };
    assert_eq!(write(&mut mailbox, 1, 10), (16, 10));
    assert_eq!(write(&mut mailbox, 1, 11), (0, 10), "the counter says that it is the same");
    assert_eq!(write(&mut mailbox, 2, 12), (16, 12));
    assert_eq!(write(&mut mailbox, 0, 13), (16, 13));
    assert_eq!(write(&mut mailbox, 0, 14), (16, 14), "0 counts nothing");
    assert_eq!(write(&mut mailbox, 1, 15), (16, 15));
    mailbox.restart();
    assert_eq!(write(&mut mailbox, 1, 16), (16, 16), "a master begins to count anew");
    // another protocol of the same mailbox
    assert_eq!(mailbox.answer(&[0, 0, 0, 0, 0, 0x22], PreOperational, &mut [0; 16]), 10);
    assert_eq!(write(&mut mailbox, 2, 17), (0, 16));
}

#[test]
fn answers_are_counted_for_masters_that_count() {
    let mut mailbox = mailbox();
    let message = |counter: u8| [10, 0, 0, 0, 0, counter << 4 | 3, 0, 0x20, 0x40, 1, 0x20, 0, 0, 0, 0, 0];
    let mut counters = Vec::new();
    for counter in [1, 2, 3, 4, 5, 6, 7, 1, 0, 2] {
        let mut answer = [0; 16];
        assert_eq!(mailbox.answer(&message(counter), Operational, &mut answer), 16);
        counters.push(answer[5] >> 4);
    }
    assert_eq!(counters, [1, 2, 3, 4, 5, 6, 7, 1, 0, 2]);
}

#[test]
fn what_is_no_request_gets_a_mailbox_error() {
    let mut mailbox = mailbox();
    let mut answer = |message: &[u8]| {
        let mut answer = [0; 16];
        assert_eq!(mailbox.answer(message, Operational, &mut answer), 10);
        assert_eq!((answer[0], answer[5] & 0x0F, answer[6..8].to_vec()), (4, 0, vec![1, 0]));
        u16::from_le_bytes([answer[8], answer[9]])
    };
    assert_eq!(answer(&[]), 6);
    assert_eq!(answer(&[20, 0, 0, 0, 0, 3, 0, 0x20]), 8);
    assert_eq!(answer(&[2, 0, 0, 0, 0, 2, 0, 0]), 2);
    // a device is not sent a response
    assert_eq!(answer(&[10, 0, 0, 0, 0, 3, 0, 0x30, 0x60, 0, 0, 0, 0, 0, 0, 0]), 4);
    assert_eq!(answer(&[3, 0, 0, 0, 0, 3, 0, 0x20, 0x40]), 6);
}

#[test]
fn an_emergency_is_said_unasked() {
    let mut answer = [0; 16];
    let emergency = Emergency { code: 0x7121, register: 0x21, data: [0; 5] };
    assert_eq!(mailbox().emergency(&emergency, &mut answer), 16);
    assert_eq!(answer, [10, 0, 0, 0, 0, 0x13, 0, 0x10, 0x21, 0x71, 0x21, 0, 0, 0, 0, 0]);
}
