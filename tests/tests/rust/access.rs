//! Every entry of every shipped device through the SDO server, against the model as JSON.

use std::collections::BTreeMap;
use std::path::Path;

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::{self, Operational, PreOperational, SafeOperational};
use devc_runtime::sdo::{AbortCode, Server, Values};
use serde_json::Value;

const STATES: [CommunicationState; 3] = [PreOperational, SafeOperational, Operational];

/// The objects of a member.
pub(crate) fn model(family: &str, member: &str) -> Vec<Value> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../generated/{family}/{family}.json"));
    let text = std::fs::read_to_string(path).expect("the output is there");
    let json: Value = serde_json::from_str(&text).expect("it is JSON");
    let members = json["members"].as_array().expect("there are members");
    let member = members.iter().find(|it| it["id"] == member).expect("there is such a member");
    member["objects"].as_array().expect("there are objects").clone()
}

/// The entries of a member, by address.
fn entries(family: &str, member: &str) -> BTreeMap<Address, Value> {
    let objects = model(family, member);
    let entries = objects.iter().flat_map(|object| object["entries"].as_array().expect("there are some"));
    entries.map(|entry| (address(entry), entry.clone())).collect()
}

fn address(entry: &Value) -> Address {
    let number = |key: &str| entry["address"][key].as_u64().expect("it is a number");
    Address::new(number("index").try_into().expect("16 bits"), number("subindex").try_into().expect("8 bits"))
}

/// Bytes of a type in an SDO, and whether it is text.
pub(crate) fn length(entry: &Value) -> (usize, bool) {
    let name = entry["data_type"].as_str().expect("it has a type");
    let bits = name.trim_start_matches(|c: char| !c.is_ascii_digit()).trim_end_matches(')');
    let bits = || bits.parse::<usize>().expect("the name ends with the width");
    match name {
        "BOOL" | "BYTE" => (1, false),
        "WORD" => (2, false),
        "DWORD" => (4, false),
        _ if name.starts_with("STRING") => (bits(), true),
        _ => (bits().div_ceil(8), false),
    }
}

/// The default as an SDO carries it; 0 or no text where there is none.
fn default(entry: &Value) -> Vec<u8> {
    match (&entry["default"], length(entry)) {
        (Value::String(text), _) => text.as_bytes().to_vec(),
        (Value::Null, (_, true)) => Vec::new(),
        (value, (length, _)) => {
            let number = value.as_i64().unwrap_or_else(|| i64::from(value.as_bool().unwrap_or(false)));
            number.to_le_bytes()[..length].to_vec()
        }
    }
}

fn verdict(is_ever: bool, is_now: bool, never: AbortCode) -> Result<(), AbortCode> {
    match (is_ever, is_now) {
        (false, _) => Err(never),
        (true, false) => Err(AbortCode::DEVICE_STATE),
        (true, true) => Ok(()),
    }
}

fn may_read(entry: &Value) -> Result<(), AbortCode> {
    verdict(entry["access"] != "wo", true, AbortCode::WRITE_ONLY)
}

fn may_write(entry: &Value, state: CommunicationState) -> Result<(), AbortCode> {
    let is_ever = entry["access"] == "rw" || entry["access"] == "wo";
    let state_of = |window| match window {
        "pre_op" => PreOperational,
        "safe_op" => SafeOperational,
        "op" => Operational,
        other => panic!("{other} is new"),
    };
    let only = entry["written"].as_str().map(state_of);
    verdict(is_ever, only.is_none_or(|only| only == state), AbortCode::READ_ONLY)
}

fn uploads<V: Values>(server: &mut Server<V>, entries: &BTreeMap<Address, Value>) {
    for (address, entry) in entries {
        for state in STATES {
            let mut buffer = [0; 256];
            let expected = may_read(entry).map(|()| default(entry));
            let data = server.upload(*address, state, &mut buffer).map(<[u8]>::to_vec);
            assert_eq!(data, expected, "{address} in {state:?}");
        }
    }
}

fn downloads<V: Values>(server: &mut Server<V>, entries: &BTreeMap<Address, Value>) {
    for (address, entry) in entries {
        let (length, is_text) = length(entry);
        for state in STATES {
            let mut download = |data: &[u8]| server.download(*address, state, data);
            let allowed = may_write(entry, state);
            assert_eq!(
                download(&vec![1; length + 1]),
                allowed.and(Err(AbortCode::LENGTH_TOO_HIGH)),
                "{address}"
            );
            if !is_text {
                let short = download(&vec![1; length - 1]);
                assert_eq!(short, allowed.and(Err(AbortCode::LENGTH_TOO_LOW)), "{address} in {state:?}");
            }
            if makes_process_data(address) && allowed.is_ok() {
                continue;
            }
            let mut data = vec![0; length];
            data[0] = 1;
            assert_eq!(download(&data), allowed, "{address} in {state:?}");
            if allowed.is_ok() && may_read(entry).is_ok() {
                let mut buffer = [0; 256];
                assert_eq!(server.upload(*address, state, &mut buffer), Ok(data.as_slice()), "{address}");
            }
        }
    }
}

/// Whether an object takes not any value, as it says what process data is made of.
fn makes_process_data(address: &Address) -> bool {
    matches!(address.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF | 0x1C12 | 0x1C13)
}

/// All subindices of all objects that are there, and some of all that are not.
fn gaps<V: Values>(server: &mut Server<V>, entries: &BTreeMap<Address, Value>) {
    let mut buffer = [0; 256];
    for index in 0..=u16::MAX {
        let is_object = entries.contains_key(&Address::new(index, 0));
        let some: &[u8] = &[0, 1, 2, 127, 255];
        let all: Vec<u8> = (0..=u8::MAX).collect();
        for subindex in if is_object { &all } else { some } {
            let address = Address::new(index, *subindex);
            let missing = match (is_object, entries.contains_key(&address)) {
                (true, true) => continue,
                (true, false) => AbortCode::NO_SUCH_SUBINDEX,
                (false, _) => AbortCode::NO_SUCH_OBJECT,
            };
            assert_eq!(server.upload(address, Operational, &mut buffer), Err(missing), "{address}");
            assert_eq!(server.download(address, Operational, &[0]), Err(missing), "{address}");
        }
    }
}

fn exhaustive<V: Values + Copy>(values: V, family: &str, member: &str) {
    let entries = entries(family, member);
    let mut server = Server::new(values, ());
    uploads(&mut server, &entries);
    gaps(&mut server, &entries);
    downloads(&mut server, &entries);
}

#[test]
fn the_c887_answers_for_every_address() {
    exhaustive(c887::dictionary::Dictionary::DEFAULT, "c887", "c887");
}

#[test]
fn each_s700_answers_for_every_address() {
    exhaustive(s700::s300::dictionary::Dictionary::DEFAULT, "s700", "s300");
    exhaustive(s700::s400::dictionary::Dictionary::DEFAULT, "s700", "s400");
    exhaustive(s700::s600::dictionary::Dictionary::DEFAULT, "s700", "s600");
    exhaustive(s700::s700::dictionary::Dictionary::DEFAULT, "s700", "s700");
}

#[test]
fn each_pmc_sc6_answers_for_every_address() {
    exhaustive(pmc_sc6::double::dictionary::Dictionary::DEFAULT, "pmc-sc6", "double");
    exhaustive(pmc_sc6::single::dictionary::Dictionary::DEFAULT, "pmc-sc6", "single");
    exhaustive(pmc_sc6::double_hires::dictionary::Dictionary::DEFAULT, "pmc-sc6", "double-hires");
    exhaustive(pmc_sc6::single_hires::dictionary::Dictionary::DEFAULT, "pmc-sc6", "single-hires");
}
