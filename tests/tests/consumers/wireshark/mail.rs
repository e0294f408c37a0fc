//! SDOs, emergencies and AL status codes by name.

use serde_json::Value as Json;

use super::capture::{Capture, LRW, sdo};
use super::{Reader, Values, mailbox};
use crate::model::{Subject, list, number, subjects, text, word};

fn fields(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

fn one(values: &Values) -> &str {
    assert_eq!(values.len(), 1, "{values:?}");
    &values[0]
}

fn prose(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn each(check: impl Fn(&Subject, &Json, &Reader)) {
    for subject in subjects() {
        for member in &subject.members {
            let Some(reader) = Reader::of(&subject, member) else { return };
            check(&subject, member, &reader);
        }
    }
}

/// The bytes that an upload of a whole number has, by its type, and what they are.
fn value(data_type: &str, is_word: bool) -> Option<(Vec<u8>, String)> {
    let width = match data_type {
        "BOOL" | "BYTE" => 8,
        "WORD" => 16,
        "DWORD" => 32,
        other => other.trim_start_matches(char::is_alphabetic).parse::<usize>().ok()?,
    };
    let known = ["BOOL", "BYTE", "WORD", "DWORD"].contains(&data_type);
    let is_number = known || data_type.starts_with("INT") || data_type.starts_with("UINT");
    if !is_number || width > 32 {
        return None;
    }
    let bytes: Vec<u8> = [0x81, 0x92, 0xA3, 0xB4][..width / 8].to_vec();
    let unsigned = bytes.iter().rev().fold(0_i64, |number, byte| number << 8 | i64::from(*byte));
    let number = if data_type.starts_with("INT") { unsigned - (1 << width) } else { unsigned };
    Some(match (data_type, is_word) {
        ("BOOL", _) => (vec![1], "1".to_owned()),
        (_, true) => (bytes, format!("0x{unsigned:X}")),
        _ => (bytes, number.to_string()),
    })
}

#[test]
fn every_sdo_has_the_name_of_its_entry() {
    each(|_, member, reader| {
        let (mut capture, mut expected) = (Capture::new(), Vec::new());
        for object in list(member, "objects") {
            for entry in list(object, "entries") {
                let address = (number(object, "index"), number(&entry["address"], "subindex"));
                let is_word = word(member, &entry["address"]).is_some();
                let value = value(text(entry, "data_type"), is_word);
                let data = value.as_ref().map_or(&[1, 2, 3, 4, 5, 6][..], |(data, _)| data);
                capture.request(mailbox(member), &sdo(2, address, &[]));
                capture.response(mailbox(member), &sdo(2, address, data));
                expected.push((capture.frames, object, entry, value));
            }
        }
        // the values in 0x1018 are those of another device
        let options = ["stations:0x1001"];
        let names = ["sdo.index", "sdo.subindex", "sdo.name", "sdo.value", "sdo.what"];
        let found = reader.read(&capture, &options, &fields(&names));
        for (frame, object, entry, value) in expected {
            let (request, response) = (&found[&(frame - 1)], &found[&frame]);
            let (index, subindex) = (number(object, "index"), number(&entry["address"], "subindex"));
            for said in [request, response] {
                assert_eq!(one(&said[0]), format!("0x{index:04x}"));
                assert_eq!(one(&said[1]), subindex.to_string());
                let name = one(&said[2]);
                let names = [prose(text(object, "name")), prose(text(entry, "name"))];
                let several = list(object, "entries").len() > 1;
                assert!(name.starts_with(&names[0]), "{name} is {}", names[0]);
                assert!(!several || name.contains(&names[1]), "{name} is {}", names[1]);
            }
            assert_eq!((one(&request[4]), one(&response[4])), ("upload request", "upload response"));
            assert!(request[3].is_empty(), "a question has no value");
            let Some((_, value)) = value else { continue };
            let said = one(&response[3]);
            let same = said == value || said.strip_prefix(&value).is_some_and(|rest| rest.starts_with(" ("));
            assert!(same, "0x{index:04X}:{subindex:02X} of {} is {said}, not {value}", text(member, "id"));
        }
    });
}

#[test]
fn emergencies_and_refusals_have_names() {
    each(|_, member, reader| {
        let (mut capture, mut expected) = (Capture::new(), Vec::new());
        for error in list(member, "errors") {
            for code in [number(error, "code"), number(error, "last")] {
                capture.emergency(mailbox(member), u16::try_from(code).unwrap());
                expected.push((capture.frames, code));
            }
        }
        let found = reader.read(
            &capture,
            &[],
            &fields(&["emergency.code", "emergency.name", "emergency.register", "emergency.data"]),
        );
        for (frame, code) in expected {
            let said = &found[&frame];
            let errors = list(member, "errors").iter();
            let mut covering: Vec<&Json> =
                errors.filter(|it| (number(it, "code")..=number(it, "last")).contains(&code)).collect();
            covering.sort_by_key(|it| it["code"] != it["last"]);
            assert_eq!(one(&said[0]), format!("0x{code:04x}"));
            assert_eq!(one(&said[1]), prose(text(covering[0], "name")));
            assert_eq!((one(&said[2]), one(&said[3])), ("0x21", "0102030405"));
        }
    });
}

/// The words are those of the tables of abort codes in ETG.1000.6, and of AL status codes in ETG.1000.6 and ETG.1020.
#[test]
fn codes_of_the_standard_have_names() {
    each(|_, member, reader| {
        let mut capture = Capture::new();
        let refusal = |code: u32| [&[0x80, 0x41, 0x60, 0][..], &code.to_le_bytes()].concat();
        let aborts =
            [(0x0601_0002, "read"), (0x0602_0000, "exist"), (0x0609_0030, "range"), (0x0800_0022, "state")];
        for (code, _) in aborts {
            capture.response(mailbox(member), &refusal(code));
        }
        for code in [0x001B_u16, 0x0016] {
            capture.read(0x130, &[&[0x12, 0, 0, 0][..], &code.to_le_bytes()].concat());
        }
        let found = reader.read(
            &capture,
            &[],
            &fields(&["sdo.abort", "sdo.reason", "al.state", "al.code", "al.reason"]),
        );
        for (frame, (code, word)) in (1..).zip(aborts) {
            assert_eq!(one(&found[&frame][0]), format!("0x{code:08x}"));
            assert!(one(&found[&frame][1]).contains(word), "{:?} of {code:08x}", found[&frame][1]);
        }
        for (frame, code, word) in [(5, "0x001b", "watchdog"), (6, "0x0016", "mailbox")] {
            assert_eq!(one(&found[&frame][2]), "Pre-Operational, error");
            assert_eq!(one(&found[&frame][3]), code);
            assert!(one(&found[&frame][4]).contains(word), "{:?}", found[&frame][4]);
        }
    });
}

/// A station that says it is something else is left to Wireshark: by an SDO, or by its EEPROM.
#[test]
fn other_devices_are_left_alone() {
    let subject = subjects().into_iter().find(|subject| subject.id == "c887").unwrap();
    let member = &subject.members[0];
    let Some(reader) = Reader::of(&subject, member) else { return };
    let identity = &member["identity"];
    let own = [number(identity, "vendor_id"), number(identity, "product_code")];
    for (vendor, product) in [(own[0], own[1]), (own[0], own[1] + 1), (own[0] + 1, own[1])] {
        let words = [vendor, product].map(|number| u32::try_from(number).unwrap().to_le_bytes()).concat();
        let by_sdo = |capture: &mut Capture| {
            capture.response(mailbox(member), &sdo(2, (0x1018, 1), &words[..4]));
            capture.response(mailbox(member), &sdo(2, (0x1018, 2), &words[4..]));
        };
        let by_eeprom = |capture: &mut Capture| {
            capture.write(0x502, &[0, 1, 8, 0, 0, 0]);
            capture.read(0x502, &[&[0x40, 0, 8, 0, 0, 0][..], &words].concat());
        };
        let ways: [&dyn Fn(&mut Capture); 2] = [&by_sdo, &by_eeprom];
        for tell in ways {
            let mut capture = Capture::new();
            tell(&mut capture);
            capture.unit(0, 0x1_0000, 42, 0x1100, true);
            capture.datagram(LRW, 0, 1, &[0; 42], 0);
            let found = reader.read(&capture, &[], &fields(&["x.controlword"]));
            let is_own = [vendor, product] == own;
            assert_eq!(found.contains_key(&capture.frames), is_own, "{vendor:X} {product:X}");
        }
    }
}
