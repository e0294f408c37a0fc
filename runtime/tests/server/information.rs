//! What a device tells of its dictionary.

use devc_runtime::coe::{
    EntryDescription, Envelope, Information, ListKind, Mailbox, ObjectDescription, Operation, Service,
};
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::PreOperational;
use devc_runtime::sdo::{AbortCode, Access, DataType, Names, Server, Values};

use crate::device::{GAIN, LIST, MIXED, RATIO, Tiny, WIDE};
use crate::master::next_counter;

static NAMES: Names = Names {
    pages: &[&[
        "Name", "Gain", "Secret", "Note", "Model", "Flags", "Wide", "Ratio", "List", "Number", "First",
        "Second", "Third", "Mixed", "Highest", "Signed", "Fixed", "Last", "Narrow", "Highest", "Flag",
        "Three", "Six", "Word",
    ]],
};

fn mailbox() -> Mailbox<Tiny> {
    Mailbox::with_information(Server::new(Tiny::NEW, ()), &NAMES)
}

/// Asks, and gives each piece of the answer: operation, pieces left, data.
fn ask(mailbox: &mut Mailbox<Tiny>, size: usize, operation: Operation, data: &[u8]) -> Vec<Piece> {
    let mut message = [0; 32];
    let envelope = Envelope { counter: next_counter(), ..Envelope::new(Service::SDO_INFORMATION) };
    Information::new(operation, data).encode(envelope, &mut message).unwrap();
    let mut answer = vec![0; size];
    let mut length = mailbox.answer(&message, PreOperational, &mut answer);
    let mut pieces = Vec::new();
    while length > 0 {
        let (envelope, body) = Envelope::open(&answer[..length]).unwrap();
        assert_eq!(
            (envelope.service, envelope.counter),
            (Service::SDO_INFORMATION, pieces.len() as u8 % 7 + 1)
        );
        let piece = Information::decode(body).unwrap();
        pieces.push((piece.operation, piece.fragments_left, piece.data.to_vec()));
        length = mailbox.proceed(&mut answer);
    }
    pieces
}

type Piece = (Operation, u16, Vec<u8>);

fn words(data: &[u8]) -> Vec<u16> {
    data.chunks(2).map(|word| u16::from_le_bytes([word[0], word[1]])).collect()
}

#[test]
fn lists_come_whole_or_in_pieces() {
    let indices: Vec<u16> = (0x2000..=0x2007).chain(0x2010..=0x2013).collect();
    for (size, count) in [(128, 1), (38, 1), (37, 2), (32, 2), (20, 4), (16, 12)] {
        let pieces = ask(&mut mailbox(), size, Operation::GetList, &[1, 0]);
        assert_eq!(pieces.len(), count, "{size} bytes");
        let left: Vec<usize> = pieces.iter().map(|piece| piece.1.into()).collect();
        assert_eq!(left, (0..count).rev().collect::<Vec<_>>());
        let data: Vec<u8> = pieces.into_iter().flat_map(|piece| piece.2).collect();
        let all = words(&data);
        assert_eq!((all[0], &all[1..]), (ListKind::All as u16, indices.as_slice()), "{size} bytes");
    }
    assert_eq!(ask(&mut mailbox(), 32, Operation::GetList, &[2, 0]), [(Operation::List, 0, vec![2, 0])]);
}

#[test]
fn the_lists_are_counted() {
    let [(operation, 0, data)] = &ask(&mut mailbox(), 32, Operation::GetList, &[0, 0])[..] else { panic!() };
    assert_eq!((*operation, words(data)), (Operation::List, vec![0, 12, 0, 0, 0, 0]));
}

fn object(index: u16) -> (DataType, u8, u8, String) {
    let [(Operation::Object, 0, data)] =
        &ask(&mut mailbox(), 32, Operation::GetObject, &index.to_le_bytes())[..]
    else {
        panic!()
    };
    let object = ObjectDescription::decode(data).unwrap();
    assert_eq!(object.index, index);
    let name = String::from_utf8(object.name.to_vec()).unwrap();
    (object.data_type, object.highest_subindex, object.code, name)
}

#[test]
fn objects_are_described() {
    assert_eq!(object(GAIN.index), (DataType::INTEGER16, 0, 7, "Gain".into()));
    assert_eq!(object(LIST), (DataType(0), 3, 8, "List".into()));
    assert_eq!(object(MIXED), (DataType(0), 4, 9, "Mixed".into()));
}

#[test]
fn entries_are_described() {
    let expected = [
        (GAIN, DataType::INTEGER16, 16, "Gain"),
        (Address::new(LIST, 0), DataType::UNSIGNED8, 8, "Number"),
        (Address::new(LIST, 3), DataType::UNSIGNED16, 16, "Third"),
        (Address::new(MIXED, 4), DataType::UNSIGNED16, 16, "Last"),
    ];
    for (address, data_type, bits, name) in expected {
        let [low, high] = address.index.to_le_bytes();
        let asked = [low, high, address.subindex, 0];
        let pieces = ask(&mut mailbox(), 64, Operation::GetEntry, &asked);
        let [(Operation::Entry, 0, data)] = &pieces[..] else { panic!("{pieces:?}") };
        let access = Tiny::NEW.table().find(address).unwrap().entry.access;
        let name = name.as_bytes();
        let entry = EntryDescription { address, value_info: 0, data_type, bits, access, values: &[], name };
        assert_eq!(EntryDescription::decode(data), Ok(entry));
    }
    let access = Tiny::NEW.table().find(GAIN).unwrap().entry.access;
    assert!(access.includes(Access::READ) && !access.includes(Access::WRITE));
}

/// What is told of an entry besides: which values, and their bytes.
fn values(address: Address, asked: u8) -> (u8, Vec<u8>) {
    let [low, high] = address.index.to_le_bytes();
    let pieces = ask(&mut mailbox(), 64, Operation::GetEntry, &[low, high, address.subindex, asked]);
    let [(Operation::Entry, 0, data)] = &pieces[..] else { panic!("{pieces:?}") };
    let entry = EntryDescription::decode(data).unwrap();
    assert!(!entry.name.is_empty() && entry.name.iter().all(u8::is_ascii_alphabetic));
    (entry.value_info, entry.values.to_vec())
}

#[test]
fn values_are_told_that_are_asked_for_and_there() {
    assert_eq!(values(GAIN, 0x7F), (0x60, vec![0xF6, 0xFF, 0xE8, 0x03]));
    assert_eq!(values(GAIN, 0x20), (0x20, vec![0xF6, 0xFF]));
    assert_eq!(values(GAIN, 0x40), (0x40, vec![0xE8, 0x03]));
    assert_eq!(values(GAIN, 0), (0, vec![]));
    assert_eq!(values(WIDE, 0x60), (0x60, vec![1, 0, 0, 0, 0, 0x80]));
    let ratio = [0.5_f32.to_le_bytes(), 2_f32.to_le_bytes()].concat();
    assert_eq!(values(RATIO, 0x60), (0x60, ratio));
    assert_eq!(values(Address::new(MIXED, 2), 0x78), (0x10, vec![0x34, 0x12]));
}

#[test]
fn what_is_not_there_is_an_error() {
    let refused = |operation, data: &[u8]| {
        let [(Operation::Error, 0, data)] = &ask(&mut mailbox(), 32, operation, data)[..] else { panic!() };
        Information::new(Operation::Error, data).abort_code()
    };
    assert_eq!(refused(Operation::GetObject, &[0xFF, 0x2F]), Some(AbortCode::NO_SUCH_OBJECT));
    assert_eq!(refused(Operation::GetEntry, &[0x10, 0x20, 9, 0]), Some(AbortCode::NO_SUCH_SUBINDEX));
    assert_eq!(refused(Operation::GetList, &[6, 0]), Some(AbortCode::VALUE_OUT_OF_RANGE));
    assert_eq!(refused(Operation::List, &[1, 0]), Some(AbortCode::UNKNOWN_COMMAND_SPECIFIER));
    let mut silent: Mailbox<Tiny> = Mailbox::new(Server::new(Tiny::NEW, ()));
    let pieces = ask(&mut silent, 32, Operation::GetList, &[1, 0]);
    let code = AbortCode::UNSUPPORTED_ACCESS.0.to_le_bytes().to_vec();
    assert_eq!(pieces, [(Operation::Error, 0, code)]);
}
