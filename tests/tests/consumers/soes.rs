//! The object list for SOES, compiled against a header of the names that the stack documents, and read as the stack reads it.

use std::fmt::Write;

use devc::emit::soes::Soes;
use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::c::{STRICT, compilers};
use crate::expected::hex;
use crate::model::{list, number, subjects, text};
use crate::tools::{compare, run};

#[test]
fn the_stack_finds_what_the_model_says() {
    let subjects = subjects();
    std::thread::scope(|scope| {
        for subject in &subjects {
            scope.spawn(move || {
                let files = Soes.emit(&subject.family, &Options::default()).0;
                for member in &subject.members {
                    let id = text(member, "id");
                    let folder = tempfile::tempdir().unwrap();
                    let write = |file: &str, content: &[u8]| {
                        std::fs::write(folder.path().join(file), content).unwrap();
                    };
                    for file in ["slave_objectlist.c", "utypes.h", "ecat_options.h"] {
                        write(file, &files[&format!("{id}.soes/{file}")]);
                    }
                    write("esc_coe.h", include_bytes!("soes.h"));
                    write("test.c", include_bytes!("soes.c"));
                    for compiler in compilers() {
                        let arguments = ["-std=c99", "-I.", "-o", "test", "test.c", "slave_objectlist.c"];
                        run(folder.path(), compiler, &[&STRICT[..], &arguments].concat());
                        compare(id, &run(folder.path(), "./test", &[]), &expected(member));
                    }
                }
            });
        }
    });
}

fn expected(member: &Json) -> String {
    let mut lines = String::new();
    for object in list(member, "objects") {
        let kind = ["var", "array", "record"].iter().position(|kind| text(object, "kind") == *kind).unwrap();
        let entries = list(object, "entries");
        let highest = number(&entries.last().unwrap()["address"], "subindex");
        let index = number(object, "index");
        writeln!(lines, "object {index:04x} {} {highest} {}", kind + 7, named(member, object)).unwrap();
        for entry in entries {
            let (code, bits) = data_type(text(entry, "data_type"));
            let subindex = number(&entry["address"], "subindex");
            let name = text(entry, "name").split_whitespace().collect::<Vec<_>>().join(" ");
            let value = hex(&value(&entry["default"], code, bits));
            writeln!(lines, "{subindex:02x} {code:04x} {bits} {:03x} {name} {value}", access(entry)).unwrap();
        }
    }
    let protocols = list(&member["mailbox"], "protocols");
    let speaks = |name: &str| u8::from(protocols.iter().any(|protocol| protocol == name));
    writeln!(lines, "{} {}", speaks("FoE"), speaks("EoE")).unwrap();
    let first = |role| list(member, "sync_managers").iter().find(|it| text(it, "role") == role);
    if let (Some(out), Some(back)) = (first("mailbox_out"), first("mailbox_in")) {
        let [a, b] = [out, back].map(|it| format!("{} {}", number(it, "address"), number(it, "size")));
        writeln!(lines, "{a} {b}").unwrap();
    }
    for area in ["outputs", "inputs"].into_iter().filter_map(first) {
        writeln!(lines, "{} {}", number(area, "address"), number(area, "control")).unwrap();
    }
    lines
}

/// The name, and where there are several axes and it does not say so itself, which it is of.
fn named(member: &Json, object: &Json) -> String {
    let axes = list(member, "axes");
    let name = text(object, "name").split_whitespace().collect::<Vec<_>>().join(" ");
    let Some(axis) = object["axis"].as_u64().filter(|_| axes.len() > 1) else { return name };
    let axis = text(&axes[usize::try_from(axis).unwrap()], "name");
    let says_so = name.split(|c: char| !c.is_alphanumeric()).any(|word| word == axis);
    if says_so { name } else { format!("{name} ({axis})") }
}

/// Number and width of ETG.1020; what is bits of a byte, a word or a double word is the number of its width.
fn data_type(name: &str) -> (u16, usize) {
    let length = || name[name.find('(').unwrap() + 1..name.len() - 1].parse::<usize>().unwrap();
    match name {
        "BOOL" => (0x01, 1),
        "INT8" => (0x02, 8),
        "INT16" => (0x03, 16),
        "INT24" => (0x10, 24),
        "INT32" => (0x04, 32),
        "INT48" => (0x13, 48),
        "INT64" => (0x15, 64),
        "UINT8" | "BYTE" => (0x05, 8),
        "UINT16" | "WORD" => (0x06, 16),
        "UINT32" | "DWORD" => (0x07, 32),
        "UINT40" => (0x18, 40),
        "UINT64" => (0x1B, 64),
        "REAL32" => (0x08, 32),
        "REAL64" => (0x11, 64),
        _ if name.starts_with("STRING") => (0x09, length() * 8),
        _ if name.starts_with("OCTET") => (0x0A, length() * 8),
        _ if name.starts_with("BIT") => {
            let bits: usize = name[3..].parse().unwrap();
            (0x2F + u16::try_from(bits).unwrap(), bits)
        }
        other => panic!("{other}"),
    }
}

/// The bits of ETG.1000.6, table 47: reading and writing in three states, process data, backup, setting.
fn access(entry: &Json) -> u16 {
    let (access, pdo) = (text(entry, "access"), text(entry, "pdo"));
    let read = if access == "wo" { 0 } else { 0b111 };
    let states = match entry["written"].as_str() {
        _ if !["rw", "wo"].contains(&access) => 0,
        None => 0b111,
        Some("pre_op") => 0b001,
        Some("pre_op_safe_op") => 0b011,
        Some("pre_op_op") => 0b101,
        Some("safe_op") => 0b010,
        Some("safe_op_op") => 0b110,
        Some("op") => 0b100,
        Some(other) => panic!("{other}"),
    };
    let flag = |is_so: bool, bit: u16| u16::from(is_so) << bit;
    read | states << 3
        | flag(pdo.contains("rx"), 6)
        | flag(pdo.contains("tx"), 7)
        | flag(entry["backup"] == true, 8)
        | flag(entry["setting"] == true, 9)
}

/// The bytes that an SDO carries; zero where there is no default.
fn value(default: &Json, code: u16, bits: usize) -> Vec<u8> {
    let mut bytes = match default {
        Json::Null => Vec::new(),
        Json::Bool(value) => vec![u8::from(*value)],
        Json::String(text) if code == 0x0A => {
            (0..text.len() / 2).map(|at| u8::from_str_radix(&text[2 * at..2 * at + 2], 16).unwrap()).collect()
        }
        Json::String(text) => text.as_bytes().to_vec(),
        number => match code {
            0x08 => (number.as_f64().unwrap() as f32).to_le_bytes().to_vec(),
            0x11 => number.as_f64().unwrap().to_le_bytes().to_vec(),
            _ => match number.as_i64() {
                Some(value) => value.to_le_bytes().to_vec(),
                None => number.as_u64().unwrap().to_le_bytes().to_vec(),
            },
        },
    };
    bytes.resize(bits.div_ceil(8), 0);
    bytes
}
