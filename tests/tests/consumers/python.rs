//! The Python modules: typed strictly, and run.

use std::fmt::Write;

use devc::emit::python::Python;
use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::expected;
use crate::model::{Print, Record, Subject, list, records, subjects, text};
use crate::tools::{compare, has_module, run, tool};

/// Names that Python or tuples keep for themselves, of those that the corner has.
const KEYWORDS: [&str; 4] = ["class", "int", "pack", "index"];

#[test]
fn modules_do_what_the_model_says() {
    let Some(python) = tool(&["python3", "python"]) else { return };
    let folder = tempfile::tempdir().unwrap();
    let mut names: Vec<String> = Vec::new();
    let subjects = subjects();
    for subject in &subjects {
        for (name, content) in Python.emit(&subject.family, &Options::default()).0 {
            std::fs::write(folder.path().join(&name), content).unwrap();
            names.push(name);
        }
    }
    assert_eq!(names.len(), 10);
    std::thread::scope(|scope| {
        scope.spawn(|| types(folder.path(), python, &names));
        for subject in &subjects {
            subject.members.iter().for_each(|member| check(subject, member, folder.path(), python));
        }
    });
}

/// The types, for who checks them.
fn types(folder: &std::path::Path, python: &str, names: &[String]) {
    if !has_module(python, "mypy") {
        return;
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    run(folder, python, &[&["-m", "mypy", "--strict", "--no-incremental"], &names[..]].concat());
}

fn check(subject: &Subject, member: &Json, folder: &std::path::Path, python: &str) {
    let id = text(member, "id").replace('-', "_");
    let records = records(member, &KEYWORDS);
    let script = folder.join(format!("test_{id}.py"));
    std::fs::write(&script, program(&id, member, &records)).unwrap();
    let output = run(folder, python, &["-B", "-W", "error", script.to_str().unwrap()]);
    compare(&format!("{} {id} in Python", subject.id), &output, &expected::lines(member, &records));
}

const HEAD: &str = r#"
import struct
import sys


def number(value: int) -> str:
    return (value & 0xFFFF_FFFF_FFFF_FFFF).to_bytes(8, "little").hex()


def refused(make: object) -> None:
    try:
        assert callable(make)
        make()
    except (ValueError, OverflowError, struct.error):
        return
    raise AssertionError("taken")


sys.stdout.reconfigure(encoding="utf-8")  # type: ignore[union-attr]
"#;

/// A program that uses all of a module.
fn program(module: &str, member: &Json, records: &[Record]) -> String {
    let mut text = format!("import {module} as it\n{HEAD}");
    for record in records.iter().filter(|record| !record.fields.is_empty()) {
        one(record, &mut text);
    }
    if list(member, "states").iter().any(|state| state["pattern"].is_string()) {
        text.push_str(
            "numbers = {None: 0} | {state: n + 1 for n, state in enumerate(it.State)}\nbefore = -1\n\
             for word in range(65536):\n    shown = numbers[it.state(word)]\n    if shown != before:\n        \
             print(f\"S {word:04x} {shown}\")\n    before = shown\n",
        );
    }
    text.push_str(
        "for code in range(65536):\n    if it.error_name(code):\n        print(f\"E {code:04x} {it.error_name(code)}\")\n\
         for code, name in it.AL_STATUS.items():\n    print(f\"A {code:04x} {name}\")\n",
    );
    for (name, _) in expected::start_ups(member) {
        writeln!(
            text,
            "for index, sub, data in it.{}:\n    print(f\"W {name} {{index:04x}} {{sub:02x}} {{data.hex()}}\")",
            name.to_uppercase()
        )
        .unwrap();
    }
    text
}

/// Lines that unpack samples, pack what came out, and print both; bytes in front are left alone, and too few are refused.
fn one(record: &Record, text: &mut String) {
    let name = &record.name;
    let class: String = name.split('_').map(|word| word[..1].to_uppercase() + &word[1..]).collect();
    let class = if class.ends_with("puts") { class } else { numbered(name) };
    for sample in record.samples() {
        let sample = expected::hex(&sample);
        writeln!(text, "v = it.{class}.unpack(b\"..\" + bytes.fromhex(\"{sample}\"), 2)").unwrap();
        let fields: Vec<String> = record
            .fields
            .iter()
            .map(|field| match field.print() {
                Print::Number => format!("number(v.{})", field.path),
                Print::Real => {
                    let letter = if field.bits == 32 { 'f' } else { 'd' };
                    format!("struct.pack(\"<{letter}\", v.{}).hex()", field.path)
                }
                Print::Bytes => format!("v.{}.hex()", field.path),
            })
            .collect();
        writeln!(text, "print(\"R {name}\", v.pack().hex(), {})", fields.join(", ")).unwrap();
    }
    writeln!(text, "refused(lambda: it.{class}.unpack(bytes({})))", record.bytes() - 1).unwrap();
    if let Some(field) =
        record.fields.iter().find(|it| it.print() == Print::Number && it.bits > 1 && !it.path.contains('.'))
    {
        writeln!(text, "refused(lambda: it.{class}({}=1 << 64).pack())", field.path).unwrap();
    }
}

/// The class of a PDO: `Rx1600`, with the configuration in front.
fn numbered(name: &str) -> String {
    name.split('_').map(|word| word[..1].to_uppercase() + &word[1..]).collect()
}
