//! What a firmware tells of its dictionary, against the model as JSON.

use devc_generated::{c887, pmc_sc6};
use devc_runtime::coe::{
    EntryDescription, Envelope, Information, Mailbox, ObjectDescription, Operation, Service,
};
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::PreOperational;
use devc_runtime::sdo::{Names, Server, Values};
use serde_json::Value;

use crate::access::{length, model};

/// The data of all pieces of an answer through a mailbox of 128 bytes.
fn ask<V: Values>(mailbox: &mut Mailbox<V>, operation: Operation, data: &[u8]) -> (Operation, Vec<u8>) {
    let (mut message, mut answer) = ([0; 128], [0; 128]);
    let envelope = Envelope::new(Service::SDO_INFORMATION);
    Information::new(operation, data).encode(envelope, &mut message).expect("it fits");
    let mut length = mailbox.answer(&message, PreOperational, &mut answer);
    let mut whole = (Operation::Error, Vec::new());
    while length > 0 {
        let (_, body) = Envelope::open(&answer[..length]).expect("it is a message");
        let piece = Information::decode(body).expect("it is information");
        whole.0 = piece.operation;
        whole.1.extend_from_slice(piece.data);
        length = mailbox.proceed(&mut answer);
    }
    whole
}

fn check_list<V: Values>(mailbox: &mut Mailbox<V>, objects: &[Value]) {
    let (operation, data) = ask(mailbox, Operation::GetList, &[1, 0]);
    assert_eq!((operation, &data[..2]), (Operation::List, [1, 0].as_slice()));
    let indices = data[2..].chunks(2).map(|index| u64::from(index[0]) | u64::from(index[1]) << 8);
    assert!(indices.eq(objects.iter().map(|object| object["index"].as_u64().expect("a number"))));
}

fn check_object<V: Values>(mailbox: &mut Mailbox<V>, object: &Value) {
    let index = u16::try_from(object["index"].as_u64().expect("a number")).expect("16 bits");
    let (operation, data) = ask(mailbox, Operation::GetObject, &index.to_le_bytes());
    assert_eq!(operation, Operation::Object, "0x{index:04X}");
    let described = ObjectDescription::decode(&data).expect("it is one");
    let code = match object["kind"].as_str() {
        Some("var") => 7,
        Some("array") => 8,
        _ => 9,
    };
    let entries = object["entries"].as_array().expect("there are some");
    let highest = entries.last().and_then(|entry| entry["address"]["subindex"].as_u64());
    assert_eq!((described.index, described.code), (index, code));
    assert_eq!(Some(u64::from(described.highest_subindex)), highest, "0x{index:04X}");
    assert_eq!(std::str::from_utf8(described.name).ok(), object["name"].as_str());
    for entry in entries {
        check_entry(mailbox, index, entry);
    }
}

fn check_entry<V: Values>(mailbox: &mut Mailbox<V>, index: u16, entry: &Value) {
    let subindex = entry["address"]["subindex"].as_u64().expect("a number").try_into().expect("8 bits");
    let [low, high] = index.to_le_bytes();
    let (operation, data) = ask(mailbox, Operation::GetEntry, &[low, high, subindex, 0]);
    let address = Address::new(index, subindex);
    assert_eq!(operation, Operation::Entry, "{address}");
    let described = EntryDescription::decode(&data).expect("it is one");
    assert_eq!(described.address, address);
    assert_eq!(usize::from(described.bits.div_ceil(8)), length(entry).0, "{address}");
    assert_eq!(std::str::from_utf8(described.name).ok(), entry["name"].as_str(), "{address}");
    let read = if entry["access"] == "wo" { 0 } else { 0x07 };
    let write = match (entry["access"].as_str(), entry["written"].as_str()) {
        (Some("rw" | "wo"), None) => 0x38,
        (Some("rw" | "wo"), Some("pre_op")) => 0x08,
        (Some("rw" | "wo"), other) => panic!("{address}: {other:?} is new"),
        _ => 0,
    };
    let mapped = match entry["pdo"].as_str() {
        Some("rx") => 0x40,
        Some("tx") => 0x80,
        Some("rx_tx") => 0xC0,
        _ => 0,
    };
    assert_eq!(described.access.0, read | write | mapped, "{address}");
}

fn tells_all<V: Values>(values: V, names: &'static Names, family: &str, member: &str) {
    let objects = model(family, member);
    let mut mailbox: Mailbox<V> = Mailbox::with_information(Server::new(values, ()), names);
    check_list(&mut mailbox, &objects);
    for object in &objects {
        check_object(&mut mailbox, object);
    }
}

#[test]
fn the_c887_tells_all_of_its_dictionary() {
    use c887::dictionary::{Dictionary, NAMES};
    tells_all(Dictionary::DEFAULT, &NAMES, "c887", "c887");
}

#[test]
fn the_pmc_sc6_tells_all_of_its_dictionary() {
    use pmc_sc6::double::dictionary::{Dictionary, NAMES};
    tells_all(Dictionary::DEFAULT, &NAMES, "pmc-sc6", "double");
}
