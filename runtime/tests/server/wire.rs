//! Messages that others recorded from real devices: with Wireshark, in the tests of `ethercrab` 0.7 (services.rs).

use devc_runtime::coe::{
    Envelope, Information, ListKind, MailboxError, Malformed, Operation, Protocol, Request, Response, Service,
};
use devc_runtime::object::Address;
use devc_runtime::sdo::AbortCode;

#[test]
fn an_abort_travels_as_a_request() {
    let frame = [0x0A, 0, 0, 0, 0, 0x63, 0, 0x20, 0x80, 0x01, 0x10, 0, 0, 0, 0x02, 0x06];
    let (envelope, body) = Envelope::open(&frame).unwrap();
    assert_eq!(envelope, Envelope { counter: 6, ..Envelope::new(Service::SDO_REQUEST) });
    let abort = Response::Abort { address: Address::new(0x1001, 0), code: AbortCode::NO_SUCH_OBJECT };
    assert_eq!(Response::decode(body), Ok(abort));
    let mut written = [0xAA; 16];
    assert_eq!(abort.encode(envelope, &mut written), Ok(16));
    assert_eq!(written, frame);
}

/// ETG.1000.4, mailbox error reply: type 1, then the code; the number of the message has three bits.
#[test]
fn what_a_mailbox_does_not_take_is_told_with_its_code() {
    let mut frame = [0xAA; 10];
    assert_eq!(MailboxError::UNSUPPORTED_PROTOCOL.encode(9, &mut frame), Ok(10));
    assert_eq!(frame, [4, 0, 0, 0, 0, 0x10, 1, 0, 2, 0]);
}

#[test]
fn an_expedited_upload_fills_four_bytes() {
    // the recording ends in front of the value, a byte of 0x1C00
    let frame = [0x0A, 0, 0, 0, 0, 0x53, 0, 0x30, 0x4F, 0, 0x1C, 4, 4, 0, 0, 0];
    let (envelope, body) = Envelope::open(&frame).unwrap();
    assert_eq!(envelope, Envelope { counter: 5, ..Envelope::new(Service::SDO_RESPONSE) });
    let address = Address::new(0x1C00, 4);
    let uploaded = Response::Uploaded { address, is_complete: false, size: Some(1), data: &[4] };
    assert_eq!(Response::decode(body), Ok(uploaded));
    let mut written = [0xAA; 16];
    assert_eq!(uploaded.encode(envelope, &mut written), Ok(16));
    assert_eq!(written, frame);
}

#[test]
fn what_lies_behind_a_message_is_no_part_of_it() {
    // an EK1914 tells its name, and what it said before is still in its mailbox
    let frame = [
        16, 0, 0, 0, 0, 99, 0, 48, 65, 8, 16, 0, 6, 0, 0, 0, 69, 75, 49, 57, 49, 52, 68, 105, 97, 103, 110,
        111, 115, 101, 32, 77, 67, 50, 0,
    ];
    let (envelope, body) = Envelope::open(&frame).unwrap();
    let address = Address::new(0x1008, 0);
    let uploaded = Response::Uploaded { address, is_complete: false, size: Some(6), data: b"EK1914" };
    assert_eq!(Response::decode(body), Ok(uploaded));
    let mut written = [0; 32];
    assert_eq!(uploaded.encode(envelope, &mut written), Ok(22));
    assert_eq!(written[..22], frame[..22]);
}

#[test]
fn a_list_is_asked_for_and_comes_in_pieces() {
    let frame = [0x08, 0, 0, 0, 0, 0x73, 0, 0x80, 0x01, 0, 0, 0, 0x01, 0];
    let (envelope, body) = Envelope::open(&frame).unwrap();
    assert_eq!(envelope, Envelope { counter: 7, ..Envelope::new(Service::SDO_INFORMATION) });
    let all = (ListKind::All as u16).to_le_bytes();
    let asked = Information::new(Operation::GetList, &all);
    assert_eq!(Information::decode(body), Ok(asked));
    let mut written = [0xAA; 14];
    assert_eq!(asked.encode(envelope, &mut written), Ok(14));
    assert_eq!(written, frame);
    // the first of two pieces, cut after three of its 57 indices
    let head = [0x0E, 0, 0, 0, 0, 0x73, 0, 0x80, 0x82, 0, 1, 0, 1, 0, 0, 0x10, 0x08, 0x10, 0x09, 0x10];
    let (_, body) = Envelope::open(&head).unwrap();
    let piece = Information::decode(body).unwrap();
    assert_eq!((piece.operation, piece.fragments_left), (Operation::List, 1));
    assert_eq!(piece.data, [1, 0, 0, 0x10, 0x08, 0x10, 0x09, 0x10]);
    let mut written = [0; 32];
    assert_eq!(piece.encode(envelope, &mut written), Ok(20));
    assert_eq!(written[..20], head);
}

#[test]
fn what_cannot_be_read_is_said() {
    let frame = [0x0A, 0, 0, 0, 0, 0x63, 0, 0x20, 0x40, 0x01, 0x10, 0, 0, 0, 0, 0];
    for length in 0..6 {
        assert_eq!(Envelope::open(&frame[..length]), Err(Malformed::TooShort));
    }
    for length in 6..16 {
        assert_eq!(Envelope::open(&frame[..length]), Err(Malformed::WrongLength));
    }
    let mut eoe = frame;
    eoe[5] = 0x62;
    let other = Malformed::OtherProtocol(Protocol::EOE);
    assert_eq!(Envelope::open(&eoe), Err(other));
    assert_eq!(MailboxError::from(other), MailboxError::UNSUPPORTED_PROTOCOL);
    for length in 0..3 {
        assert_eq!(Request::decode(&frame[8..][..length + 1]), Err(Malformed::TooShort));
    }
    assert_eq!(Request::decode(&[0xA0; 8]), Err(Malformed::UnknownCommand(0xA0)));
    let request = Request::Upload { address: Address::new(0x1001, 0), is_complete: false };
    for length in 0..16 {
        let encoded = request.encode(Envelope::new(Service::SDO_REQUEST), &mut [0; 16][..length]);
        assert_eq!(encoded, Err(Malformed::NoRoom));
    }
}
