//! Whole objects at once.

use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::{self, Operational, PreOperational};
use devc_runtime::sdo::{AbortCode, Part, Server};

use crate::device::{APART, GAIN, LIST, MIXED, NARROW, Tiny};

fn server() -> Server<Tiny> {
    Server::new(Tiny::NEW, ())
}

fn upload(from: Address, state: CommunicationState) -> Result<Vec<u8>, AbortCode> {
    let mut buffer = [0xAA; 32];
    let mut part = Part::new(&mut buffer, 0);
    server().upload_complete(from, state, &mut part).map(|()| part.bytes().to_vec())
}

#[test]
fn entries_follow_each_other_up_to_their_number() {
    let list = vec![2, 0, 1, 1, 2, 2];
    assert_eq!(upload(Address::new(LIST, 0), Operational), Ok(list.clone()));
    assert_eq!(upload(Address::new(LIST, 1), Operational), Ok(list[2..].to_vec()));
}

#[test]
fn what_cannot_be_read_is_zero() {
    let mixed = vec![4, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0x34, 0x12, 0, 0];
    assert_eq!(upload(Address::new(MIXED, 0), Operational), Ok(mixed));
}

#[test]
fn bits_are_side_by_side_and_bytes_begin_at_bytes() {
    let data = [4, 0, 0b0011 << 4 | 0b101 << 1 | 1, 0b11, 0x34, 0x12];
    let at = Address::new(NARROW, 0);
    assert_eq!(upload(at, Operational), Ok(data.to_vec()));
    assert_eq!(upload(Address::new(NARROW, 1), Operational), Ok(data[2..].to_vec()));
    let mut server = server();
    let other = [0, 0, 0b0110 << 4 | 0b010 << 1, 0b01, 0xCD, 0xAB];
    assert_eq!(server.download_complete(at, Operational, &other), Ok(()));
    assert_eq!(server.values.narrow, (false, 0b010, 0b01_0110, 0xABCD));
    assert_eq!(server.download_complete(Address::new(NARROW, 1), Operational, &data[2..]), Ok(()));
    assert_eq!(server.values, Tiny::NEW);
}

#[test]
fn a_whole_byte_behind_a_bit_begins_at_a_byte() {
    let data = [4, 0, 1, 0b101, 0b11_0011, 0x34, 0x12];
    assert_eq!(upload(Address::new(APART, 0), Operational), Ok(data.to_vec()));
}

#[test]
fn some_objects_have_no_whole() {
    assert_eq!(upload(GAIN, Operational), Err(AbortCode::UNSUPPORTED_ACCESS));
    assert_eq!(upload(Address::new(0x2FFF, 0), Operational), Err(AbortCode::NO_SUCH_OBJECT));
    assert_eq!(upload(Address::new(LIST, 2), Operational), Err(AbortCode::NO_SUCH_SUBINDEX));
}

#[test]
fn a_whole_object_is_written() {
    let mut server = server();
    let data = [3, 0, 7, 0, 8, 0, 9, 0];
    assert_eq!(server.download_complete(Address::new(LIST, 0), PreOperational, &data), Ok(()));
    assert_eq!((server.values.count, server.values.list), (3, [7, 8, 9]));
    assert_eq!(server.download_complete(Address::new(LIST, 1), PreOperational, &data[2..]), Ok(()));
    let mixed = [0, 0, 1, 0, 0, 0, 0xFF, 0xFF, 5, 0];
    assert_eq!(server.download_complete(Address::new(MIXED, 0), Operational, &mixed), Ok(()));
    assert_eq!(server.values.mixed, (1, 5));
}

#[test]
fn nothing_is_written_unless_all_is_allowed() {
    let mut server = server();
    let mut download = |state, data: &[u8]| server.download_complete(Address::new(LIST, 0), state, data);
    assert_eq!(download(Operational, &[1, 0, 7, 0]), Err(AbortCode::DEVICE_STATE));
    assert_eq!(download(PreOperational, &[1, 0, 7, 0, 8, 0]), Err(AbortCode::LENGTH_TOO_HIGH));
    assert_eq!(download(PreOperational, &[2, 0, 7, 0, 8]), Err(AbortCode::LENGTH_TOO_LOW));
    assert_eq!(download(PreOperational, &[4, 0, 7, 0, 8, 0, 9, 0]), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(server.values, Tiny::NEW);
}
