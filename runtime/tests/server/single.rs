//! Uploads and downloads of single entries.

use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::{Operational, PreOperational, SafeOperational};
use devc_runtime::sdo::{AbortCode, Part, Server};

use crate::device::{FLAGS, GAIN, LIST, MIXED, MODEL, NAME, NOTE, RATIO, SECRET, Tiny, WIDE};

fn server() -> Server<Tiny> {
    Server::new(Tiny::NEW, ())
}

fn upload(server: &mut Server<Tiny>, address: Address) -> Result<Vec<u8>, AbortCode> {
    server.upload(address, Operational, &mut [0; 32]).map(<[u8]>::to_vec)
}

#[test]
fn values_come_as_they_are_on_the_wire() {
    let mut server = server();
    let expected = [
        (NAME, b"tiny".to_vec()),
        (GAIN, vec![5, 0]),
        (NOTE, b"hi".to_vec()),
        (MODEL, b"model 1".to_vec()),
        (WIDE, vec![1, 2, 3]),
        (RATIO, vec![0, 0, 0xC0, 0x3F]),
        (Address::new(LIST, 0), vec![2]),
        (Address::new(LIST, 3), vec![3, 3]),
        (Address::new(MIXED, 0), vec![4]),
        (Address::new(MIXED, 1), vec![0xFF; 4]),
        (Address::new(MIXED, 2), vec![0x34, 0x12]),
    ];
    for (address, data) in expected {
        assert_eq!(upload(&mut server, address), Ok(data), "{address}");
    }
}

#[test]
fn the_first_fault_is_told() {
    let mut server = server();
    let mut download = |address, state, data: &[u8]| server.download(address, state, data);
    let too_long = [0xFF; 9];
    assert_eq!(download(Address::new(0x1FFF, 9), Operational, &too_long), Err(AbortCode::NO_SUCH_OBJECT));
    assert_eq!(download(Address::new(0x2001, 9), Operational, &too_long), Err(AbortCode::NO_SUCH_SUBINDEX));
    assert_eq!(download(NAME, Operational, &too_long), Err(AbortCode::READ_ONLY));
    assert_eq!(download(MODEL, PreOperational, &too_long), Err(AbortCode::READ_ONLY));
    assert_eq!(download(GAIN, SafeOperational, &too_long), Err(AbortCode::DEVICE_STATE));
    assert_eq!(download(GAIN, PreOperational, &too_long), Err(AbortCode::LENGTH_TOO_HIGH));
    assert_eq!(download(GAIN, PreOperational, &[0xFF]), Err(AbortCode::LENGTH_TOO_LOW));
    assert_eq!(download(GAIN, PreOperational, &[0xF5, 0xFF]), Err(AbortCode::VALUE_TOO_LOW));
    assert_eq!(download(GAIN, PreOperational, &[0xE9, 0x03]), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(server.values, Tiny::NEW);
    assert_eq!(upload(&mut server, SECRET), Err(AbortCode::WRITE_ONLY));
}

#[test]
fn what_is_allowed_is_written() {
    let mut server = server();
    let mut download = |address, data: &[u8]| server.download(address, PreOperational, data);
    assert_eq!(download(GAIN, &[0xF6, 0xFF]), Ok(()));
    assert_eq!(download(SECRET, &[4, 3, 2, 1]), Ok(()));
    assert_eq!(download(WIDE, &[9, 0, 0]), Ok(()));
    assert_eq!(download(RATIO, &0.5_f32.to_le_bytes()), Ok(()));
    assert_eq!(download(Address::new(LIST, 2), &[7, 7]), Ok(()));
    assert_eq!(download(Address::new(MIXED, 4), &[8, 0]), Ok(()));
    let expected = Tiny {
        gain: -10,
        secret: 0x0102_0304,
        wide: [9, 0, 0],
        ratio: 0.5,
        list: [0x0101, 0x0707, 0x0303],
        mixed: (-1, 8),
        ..Tiny::NEW
    };
    assert_eq!(server.values, expected);
}

#[test]
fn a_text_may_be_shorter_than_its_entry() {
    let mut server = server();
    for (text, kept) in [("longest!", *b"longest!"), ("abc", *b"abc\0\0\0\0\0"), ("", [0; 8])] {
        assert_eq!(server.download(NOTE, Operational, text.as_bytes()), Ok(()));
        assert_eq!(server.values.note, kept);
        assert_eq!(upload(&mut server, NOTE), Ok(text.into()));
    }
    assert_eq!(server.download(NOTE, Operational, b"too long!"), Err(AbortCode::LENGTH_TOO_HIGH));
}

#[test]
fn bits_bytes_and_fractions_have_bounds() {
    let mut server = server();
    assert_eq!(server.download(FLAGS, Operational, &[7]), Ok(()));
    assert_eq!(server.download(FLAGS, Operational, &[8]), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(server.download(WIDE, Operational, &[0, 0, 0x80]), Ok(()));
    assert_eq!(server.download(WIDE, Operational, &[1, 0, 0x80]), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(server.download(WIDE, Operational, &[0, 0, 0]), Err(AbortCode::VALUE_TOO_LOW));
    let mut ratio = |value: f32| server.download(RATIO, Operational, &value.to_le_bytes());
    assert_eq!(ratio(2.0), Ok(()));
    assert_eq!(ratio(2.5), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(ratio(f32::NEG_INFINITY), Err(AbortCode::VALUE_TOO_LOW));
    assert_eq!(ratio(f32::NAN), Err(AbortCode::VALUE_OUT_OF_RANGE));
}

#[test]
fn a_number_of_entries_cannot_exceed_them() {
    let mut server = server();
    let count = Address::new(LIST, 0);
    assert_eq!(server.download(count, PreOperational, &[3]), Ok(()));
    assert_eq!(server.download(count, PreOperational, &[4]), Err(AbortCode::VALUE_TOO_HIGH));
}

#[test]
fn a_small_buffer_gets_a_part() {
    let mut server = server();
    assert_eq!(server.upload(MODEL, Operational, &mut [0; 4]), Err(AbortCode::OUT_OF_MEMORY));
    let mut read = Vec::new();
    loop {
        let mut buffer = [0; 3];
        let mut part = Part::new(&mut buffer, read.len());
        assert_eq!(server.read(MODEL, Operational, &mut part), Ok(()));
        assert_eq!(part.total(), 7);
        let is_last = part.is_last();
        read.extend_from_slice(part.bytes());
        if is_last {
            break;
        }
    }
    assert_eq!(read, b"model 1");
}
