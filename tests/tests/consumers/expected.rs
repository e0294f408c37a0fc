//! The lines that the program of a member has to print.

use std::fmt::Write;

use serde_json::Value as Json;

use crate::model::{Record, list, name, number, text};

/// What a member's program prints.
pub(crate) fn lines(member: &Json, records: &[Record]) -> String {
    let mut lines = String::new();
    for record in records.iter().filter(|record| !record.fields.is_empty()) {
        for sample in record.samples() {
            let values: Vec<String> = record.fields.iter().map(|field| field.printed(&sample)).collect();
            writeln!(lines, "R {} {} {}", record.name, hex(&record.repacked(&sample)), values.join(" "))
                .unwrap();
        }
    }
    states(member, &mut lines);
    codes(member, &mut lines);
    for (name, writes) in start_ups(member) {
        for write in &writes {
            let (address, data) = (&write["address"], bytes(&write["data"]));
            let (index, subindex) = (number(address, "index"), number(address, "subindex"));
            writeln!(lines, "W {name} {index:04x} {subindex:02x} {}", hex(&data)).unwrap();
        }
    }
    lines
}

pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

pub(crate) fn bytes(json: &Json) -> Vec<u8> {
    json.as_array().unwrap().iter().map(|byte| u8::try_from(byte.as_u64().unwrap()).unwrap()).collect()
}

/// For each word that shows another state than the one before: the word, and the number of the state from 1 on.
fn states(member: &Json, lines: &mut String) {
    let patterns: Vec<String> = list(member, "states")
        .iter()
        .filter_map(|state| state["pattern"].as_str())
        .map(|pattern| pattern.replace(' ', "").chars().rev().collect())
        .collect();
    let shows = |pattern: &String, word: u32| {
        pattern.chars().enumerate().all(|(bit, wanted)| match wanted {
            '0' => (word >> bit) & 1 == 0,
            '1' => (word >> bit) & 1 == 1,
            _ => true,
        })
    };
    let mut before = usize::MAX;
    for word in 0..=0xFFFF_u32 {
        let state = patterns.iter().position(|pattern| shows(pattern, word)).map_or(0, |place| place + 1);
        if state != before && !patterns.is_empty() {
            writeln!(lines, "S {word:04x} {state}").unwrap();
        }
        before = state;
    }
}

fn codes(member: &Json, lines: &mut String) {
    let errors = list(member, "errors");
    let ranges = |error: &&Json| error["code"] != error["last"];
    for code in 0..=0xFFFF_usize {
        let holds = |error: &&&Json| (number(error, "code")..=number(error, "last")).contains(&code);
        let single = errors.iter().filter(|it| !ranges(it)).collect::<Vec<_>>();
        let range = errors.iter().filter(ranges).collect::<Vec<_>>();
        if let Some(error) = single.iter().find(|it| holds(it)).or_else(|| range.iter().find(|it| holds(it)))
        {
            writeln!(lines, "E {code:04x} {}", prose(text(error, "name"))).unwrap();
        }
    }
    for code in list(member, "al_status_codes") {
        writeln!(lines, "A {:04x} {}", number(code, "code"), prose(text(code, "name"))).unwrap();
    }
}

fn prose(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The start-up lists by the names that they have in a program, with their rows in order.
pub(crate) fn start_ups(member: &Json) -> Vec<(String, Vec<&Json>)> {
    let mut lists: Vec<(String, Vec<&Json>)> = Vec::new();
    for configuration in list(member, "configurations") {
        for write in list(configuration, "startup") {
            let tail = match text(write, "transition") {
                "PS" => String::new(),
                other => format!("_{}", other.to_lowercase()),
            };
            let name = format!("start_up_{}{tail}", name(text(configuration, "id"), &[]));
            match lists.iter_mut().find(|(known, _)| *known == name) {
                Some((_, writes)) => writes.push(write),
                None => lists.push((name, vec![write])),
            }
        }
    }
    lists
}
