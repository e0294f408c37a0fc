//! Structured Text, read by a grammar of the standard and by `blark`, which knows that of TwinCAT.

use std::collections::{BTreeMap, BTreeSet};

use devc::emit::structured_text::StructuredText;
use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::expected;
use crate::model::{Field, Print, list, name, number, records, subjects, text};
use crate::tools::{has_module, run, tool};

#[test]
fn parsers_read_what_the_model_says() {
    let modules = ["blark", "tree_sitter_iec61131_3_st"];
    let has_all = |python: &&str| modules.iter().all(|module| has_module(python, module));
    let Some(python) = tool(&["python3", "python"]).filter(has_all) else { return };
    let subjects = subjects();
    std::thread::scope(|scope| {
        for subject in &subjects {
            scope.spawn(move || {
                let files = StructuredText.emit(&subject.family, &Options::default()).0;
                for (number, member) in subject.members.iter().enumerate() {
                    let id = text(member, "id");
                    let folder = tempfile::tempdir().unwrap();
                    std::fs::write(folder.path().join("it.st"), &files[&format!("{id}.st")]).unwrap();
                    let reader = include_str!("structured_text.py");
                    // what blark takes minutes for, the members of a family have in common
                    if number > 0 {
                        run(folder.path(), python, &["-c", reader, "it.st", "grammar"]);
                        continue;
                    }
                    let output = run(folder.path(), python, &["-c", reader, "it.st"]);
                    let read = String::from_utf8(output.stdout).unwrap();
                    let prefix =
                        if subject.id == id { id.to_owned() } else { format!("{}-{id}", subject.id) };
                    check(member, &name(&prefix, &[]).to_uppercase(), &read);
                }
            });
        }
    });
}

fn check(member: &Json, prefix: &str, read: &str) {
    let lines: BTreeSet<&str> = read.lines().collect();
    let has = |line: &str| assert!(lines.contains(line), "{prefix}: no {line:?}");
    let identity = &member["identity"];
    for key in ["vendor_id", "product_code", "revision"] {
        has(&format!("constant {prefix}_{} UDINT {}", key.to_uppercase(), number(identity, key)));
    }
    let values = |kind: &str, named: &str| -> BTreeSet<i64> {
        let wanted = |line: &&&str| line.starts_with(kind) && line.contains(&format!("{prefix}_{named}"));
        lines.iter().filter(wanted).map(|line| line.rsplit(' ').next().unwrap().parse().unwrap()).collect()
    };
    let all =
        |list: &[Json], key: &str| list.iter().map(|it| it[key].as_i64().unwrap()).collect::<BTreeSet<_>>();
    assert_eq!(values("constant", "OD_"), all(list(member, "objects"), "index"), "{prefix}");
    assert_eq!(values("value", "MODE_"), all(list(member, "modes"), "code"), "{prefix}");
    words(member, prefix, &lines);
    states(member, read);
    texts(member, prefix, &lines);
    writes(member, prefix, read);
    structs(member, prefix, read);
}

/// Masks by name; a long name is cut, so that the whole has 63 characters with what may stand behind it.
fn words(member: &Json, prefix: &str, lines: &BTreeSet<&str>) {
    let room = 63 - prefix.len() - 1 - 16;
    for word in list(member, "words") {
        let of = match number(word, "bits") {
            8 => "BYTE",
            16 => "WORD",
            _ => "DWORD",
        };
        for field in list(word, "fields").iter().filter(|it| it["reserved"] != true && it["per_mode"] != true)
        {
            let (low, high) = (number(field, "low"), number(field, "high"));
            let mask: u64 = (low..=high).map(|bit| 1 << bit).sum();
            let id = name(&format!("{}-{}", text(word, "id"), text(field, "id")), &[]).to_uppercase();
            let begin = format!("constant {prefix}_{}", &id[..id.len().min(room)]);
            let end = format!(" {of} {mask}");
            let is_there = lines.iter().any(|line| line.starts_with(&begin) && line.ends_with(&end));
            assert!(is_there, "{begin}{end}");
        }
    }
}

/// Masks and patterns in order, each with a state of its own.
fn states(member: &Json, read: &str) {
    let found: Vec<Vec<&str>> = read
        .lines()
        .filter_map(|line| line.strip_prefix("state "))
        .map(|it| it.split(' ').collect())
        .collect();
    let patterns = list(member, "states").iter().filter_map(|state| state["pattern"].as_str());
    let expected: Vec<[String; 2]> = patterns
        .map(|pattern| {
            let digits = pattern.replace(' ', "");
            let bits = |of: &dyn Fn(char) -> bool| {
                digits.chars().fold(0_u32, |bits, c| bits << 1 | u32::from(of(c)))
            };
            [bits(&|c| c != 'x').to_string(), bits(&|c| c == '1').to_string()]
        })
        .collect();
    let patterns: Vec<[String; 2]> = found.iter().map(|it| [it[0].to_owned(), it[1].to_owned()]).collect();
    assert_eq!(patterns, expected);
    let names: BTreeSet<&str> = found.iter().map(|it| it[2]).collect();
    assert_eq!(names.len(), found.len(), "each has a name of its own");
}

fn texts(member: &Json, prefix: &str, lines: &BTreeSet<&str>) {
    let mut expected = BTreeSet::new();
    for (key, function) in [("errors", "ERROR_NAME"), ("al_status_codes", "AL_STATUS_NAME")] {
        for row in list(member, key) {
            let code = number(row, "code");
            let last = row["last"].as_u64().map_or(code, |last| usize::try_from(last).unwrap());
            let name = text(row, "name").split_whitespace().collect::<Vec<_>>().join(" ");
            let name: String = name.chars().map(|c| if c > '\u{FF}' { '?' } else { c }).collect();
            expected.insert(format!("text {prefix}_{function} {code} {last} {name}"));
        }
    }
    let found: BTreeSet<String> =
        lines.iter().filter(|line| line.starts_with("text ")).map(|line| (*line).to_owned()).collect();
    // the first of two names for one code is taken
    assert!(found.is_subset(&expected), "{:#?}", found.difference(&expected).collect::<Vec<_>>());
    let codes = |of: &BTreeSet<String>| -> BTreeSet<String> {
        of.iter().map(|line| line.splitn(5, ' ').take(4).collect::<Vec<_>>().join(" ")).collect()
    };
    assert_eq!(codes(&found), codes(&expected));
}

/// The start-up lists in order, each write with its bytes.
fn writes(member: &Json, prefix: &str, read: &str) {
    let found: Vec<&str> = read.lines().filter_map(|line| line.strip_prefix("write ")).collect();
    let lists = expected::start_ups(member);
    let expected = lists.iter().flat_map(|(of, writes)| {
        writes.iter().map(move |write| {
            let (index, subindex) =
                (number(&write["address"], "index"), number(&write["address"], "subindex"));
            let bytes = list(write, "data").iter().map(|byte| format!("{:02x}", byte.as_u64().unwrap()));
            format!("{prefix}_{} {index} {subindex} {}", of.to_uppercase(), bytes.collect::<String>())
        })
    });
    assert_eq!(found, expected.collect::<Vec<_>>());
}

/// Each struct has the bytes of its PDO, and each value lies in it where it travels: as a number of its type, or within bytes.
fn structs(member: &Json, prefix: &str, read: &str) {
    let mut found: BTreeMap<&str, Vec<(&str, usize, &str)>> = BTreeMap::new();
    for line in read.lines().filter_map(|line| line.strip_prefix("field ")) {
        let [of, field, kind] = line.splitn(3, ' ').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let members = found.entry(of).or_default();
        assert!(members.iter().all(|known| !known.0.eq_ignore_ascii_case(field)), "{of} has two of {field}");
        members.push((field, size(kind), kind));
    }
    let pdos = records(member, &[])
        .into_iter()
        .filter(|record| record.fields.iter().all(|it| !it.path.contains('.')));
    for record in pdos.filter(|record| !record.fields.is_empty()) {
        let of = format!("{prefix}_{}", record.name.to_uppercase());
        let members = found.get(of.as_str()).unwrap_or_else(|| panic!("no {of}"));
        assert_eq!(members.iter().map(|it| it.1).sum::<usize>(), record.bytes(), "{of}");
        for field in &record.fields {
            let mut at = 0;
            let holds = members.iter().any(|(_, size, kind)| {
                let first = at;
                at += size;
                let inside = first * 8 <= field.offset && field.offset + field.bits <= at * 8;
                inside && (kind.contains("BYTE") || first * 8 == field.offset && *kind == number_of(field))
            });
            assert!(holds, "{of} has nothing for {}", field.path);
        }
    }
}

fn size(kind: &str) -> usize {
    match kind {
        "SINT" | "USINT" | "BYTE" => 1,
        "INT" | "UINT" => 2,
        "DINT" | "UDINT" | "REAL" => 4,
        "LINT" | "ULINT" | "LREAL" => 8,
        _ => {
            let last = kind.strip_prefix("ARRAY[0..").and_then(|it| it.strip_suffix("] OF BYTE"));
            last.unwrap_or_else(|| panic!("{kind}")).parse::<usize>().unwrap() + 1
        }
    }
}

/// The type that holds a value of all bits of its bytes.
fn number_of(field: &Field) -> String {
    let signed = field.data_type.starts_with("INT") && !field.is_word;
    let of = match (field.print(), field.bits) {
        (Print::Real, 32) => return "REAL".to_owned(),
        (Print::Real, _) => return "LREAL".to_owned(),
        (_, 8) => "SINT",
        (_, 16) => "INT",
        (_, 32) => "DINT",
        _ => "LINT",
    };
    if signed { of.to_owned() } else { format!("U{of}") }
}
