//! The data sheets, read by the Python package `canopen`.

use std::fmt::Write;

use devc::emit::eds::Eds;
use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::model::{list, number, subjects, text};
use crate::tools::{compare, has_module, run, tool};

/// What it found: device, then index, subindex, type, access, whether it can be mapped, limits and default of each entry.
const READER: &str = r#"
import sys
import canopen
from canopen.objectdictionary import ODVariable
sys.stdout.reconfigure(encoding="utf-8")
od = canopen.import_od(sys.argv[1])
it = od.device_information
print(it.vendor_name, it.vendor_number, it.product_name, it.product_number, it.revision_number)
print(it.nr_of_RXPDO, it.nr_of_TXPDO, sorted(it.allowed_baudrates))
for index in sorted(od):
    members = {0: od[index]} if isinstance(od[index], ODVariable) else dict(od[index].subindices)
    for sub, entry in sorted(members.items()):
        default = entry.default.hex() if isinstance(entry.default, bytes) else entry.default
        print(f"{index:04x} {sub:02x} {entry.data_type:#x} {entry.access_type} {entry.pdo_mappable}", entry.min, entry.max, default)
"#;

#[test]
fn canopen_reads_what_the_model_says() {
    let Some(python) = tool(&["python3", "python"]).filter(|python| has_module(python, "canopen")) else {
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for subject in subjects() {
        let files = Eds.emit(&subject.family, &Options::default()).0;
        for member in &subject.members {
            let name = format!("{}.eds", text(member, "id"));
            std::fs::write(folder.path().join(&name), &files[&name]).unwrap();
            let output = run(folder.path(), python, &["-c", READER, &name]);
            compare(&name, &output, &expected(member));
            count += 1;
        }
    }
    assert_eq!(count, 10);
}

fn expected(member: &Json) -> String {
    let mut lines = String::new();
    let identity = &member["identity"];
    let id = |key| identity[key].as_u64().unwrap();
    let (vendor, product) = (text(member, "vendor"), text(member, "name"));
    writeln!(lines, "{vendor} {} {product} {} {}", id("vendor_id"), id("product_code"), id("revision"))
        .unwrap();
    let pdos = |way| list(member, "pdos").iter().filter(|pdo| text(pdo, "direction") == way).count();
    writeln!(lines, "{} {} []", pdos("rx"), pdos("tx")).unwrap();
    for entry in list(member, "objects").iter().flat_map(|object| list(object, "entries")) {
        let address = &entry["address"];
        let (index, subindex) = (number(address, "index"), number(address, "subindex"));
        let kind = code(text(entry, "data_type"));
        let limit =
            |key| shown(&entry[key], kind).filter(|_| !matches!(kind, 0x08 | 0x11 | 0x10 | 0x12..=0x14));
        let limits = [limit("min"), limit("max")].map(|it| it.unwrap_or_else(|| "None".to_owned()));
        let mappable = if text(entry, "pdo") == "none" { "False" } else { "True" };
        writeln!(
            lines,
            "{index:04x} {subindex:02x} {kind:#x} {} {mappable} {} {}",
            access(entry),
            limits.join(" "),
            shown(&entry["default"], kind).unwrap_or_else(|| "None".to_owned())
        )
        .unwrap();
    }
    lines
}

/// Numbers of CiA 301; what is bits is the number of its width.
fn code(data_type: &str) -> u16 {
    match data_type {
        "BOOL" | "BIT1" => 0x01,
        "INT8" => 0x02,
        "INT16" => 0x03,
        "INT24" => 0x10,
        "INT32" => 0x04,
        "INT48" => 0x13,
        "INT64" => 0x15,
        "UINT16" | "WORD" => 0x06,
        "UINT32" | "DWORD" => 0x07,
        "UINT40" => 0x18,
        "UINT64" => 0x1B,
        "REAL32" => 0x08,
        "REAL64" => 0x11,
        "UINT8" | "BYTE" => 0x05,
        _ if data_type.starts_with("STRING") => 0x09,
        _ if data_type.starts_with("BIT") => 0x05,
        other => panic!("{other}"),
    }
}

/// What can be written and mapped says to which process data it goes.
fn access(entry: &Json) -> &str {
    match (text(entry, "access"), text(entry, "pdo")) {
        ("rw", "rx") => "rww",
        ("rw", "tx") => "rwr",
        (access, _) => access,
    }
}

/// As Python prints it.
fn shown(value: &Json, kind: u16) -> Option<String> {
    match value {
        Json::Null => None,
        Json::Bool(value) => Some(u8::from(*value).to_string()),
        Json::String(text) => Some(text.split_whitespace().collect::<Vec<_>>().join(" ")),
        number if matches!(kind, 0x08 | 0x11) => Some(format!("{:?}", number.as_f64().unwrap())),
        number => Some(number.to_string()),
    }
}
