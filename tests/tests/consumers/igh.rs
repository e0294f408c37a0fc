//! The tables for the EtherLab master, compiled against a header of the same names that prints each call.

use std::fmt::Write;

use devc::emit::igh::Igh;
use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::c::STRICT;
use crate::expected::{bytes, hex};
use crate::model::{list, name, number, subjects, text};
use crate::tools::{compare, run, tool};

const HEADER: &str = include_str!("ecrt.h");

#[test]
fn the_master_is_told_what_the_model_says() {
    let Some(compiler) = tool(&["gcc", "cc"]) else { return };
    for subject in subjects() {
        let files = Igh.emit(&subject.family, &Options::default()).0;
        for member in &subject.members {
            let id = text(member, "id");
            let folder = tempfile::tempdir().unwrap();
            let prefix = if subject.id == id { id.to_owned() } else { format!("{}_{id}", subject.id) };
            let write =
                |file: &str, content: &[u8]| std::fs::write(folder.path().join(file), content).unwrap();
            write("ecrt.h", HEADER.as_bytes());
            write("tables.c", &files[&format!("{id}.igh.c")]);
            write("test.c", program(&prefix.replace('-', "_"), member).as_bytes());
            let arguments = [&STRICT[..], &["-std=c99", "-I.", "-o", "test", "test.c"]].concat();
            run(folder.path(), compiler, &arguments);
            compare(id, &run(folder.path(), "./test", &[]), &expected(member));
        }
    }
}

/// The configurations that there are ways to set up for, the default without a name.
fn ways(member: &Json) -> Vec<(String, Option<&Json>)> {
    let configurations = list(member, "configurations");
    let default = configurations.iter().find(|it| it["default"] == true);
    let named = configurations.iter().map(|it| (format!("_{}", name(text(it, "id"), &[])), Some(it)));
    std::iter::once((String::new(), default)).chain(named).collect()
}

fn program(prefix: &str, member: &Json) -> String {
    let mut program = String::from("#include \"tables.c\"\nint main(void)\n{\n");
    for (way, _) in ways(member) {
        writeln!(
            program,
            "    printf(\"way {way}\\n\");\n    if ({prefix}_igh{way}_configure(NULL) != 0) {{ return 1; }}"
        )
        .unwrap();
        writeln!(program, "    {{\n        struct {prefix}_igh_places it = {{ 1, 1 }};").unwrap();
        writeln!(program, "        if ({prefix}_igh{way}_place(NULL, NULL, &it) != 0) {{ return 2; }}")
            .unwrap();
        program.push_str("        printf(\"places %u %u\\n\", it.sm2, it.sm3);\n    }\n");
    }
    for mode in clocks(member) {
        let id = name(text(mode, "id"), &[]);
        writeln!(program, "    {prefix}_igh_dc_{id}_assign_activate(NULL, 2000000u);").unwrap();
    }
    program + "    return 0;\n}\n"
}

/// None where the device makes no use of them.
fn clocks(member: &Json) -> &[Json] {
    let modes = list(member, "sync_modes");
    if modes.iter().any(|mode| mode["assign_activate"] != 0) { modes } else { &[] }
}

fn expected(member: &Json) -> String {
    let mut lines = String::new();
    for (way, configuration) in ways(member) {
        writeln!(lines, "way {way}").unwrap();
        for manager in list(member, "sync_managers") {
            sync_manager(member, configuration, manager, &mut lines);
        }
        for write in configuration.iter().flat_map(|it| list(it, "startup")) {
            let address = &write["address"];
            let (index, subindex) = (number(address, "index"), number(address, "subindex"));
            let own = matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF | 0x1C12 | 0x1C13);
            if !own && ["PS", "IP"].contains(&text(write, "transition")) {
                writeln!(lines, "sdo {index:04x} {subindex:02x} {}", hex(&bytes(&write["data"]))).unwrap();
            }
        }
        lines.push_str("places 2000 3000\n");
    }
    for mode in clocks(member) {
        let sync0 = &mode["sync0"];
        let cycles = sync0["cycles"].as_i64().unwrap_or(0);
        let shift = sync0["shift_ns"].as_i64().unwrap_or(0);
        writeln!(lines, "dc {:04x} {} {shift} 0 0", number(mode, "assign_activate"), 2_000_000 * cycles)
            .unwrap();
    }
    lines
}

fn sync_manager(member: &Json, configuration: Option<&Json>, manager: &Json, lines: &mut String) {
    let role = text(manager, "role");
    let is_output = u8::from(role == "outputs" || role == "mailbox_out");
    let watchdog = u8::from(number(manager, "control") & 0x40 != 0 && role == "outputs");
    writeln!(lines, "sm {} {is_output} {watchdog}", number(manager, "number")).unwrap();
    let chosen = configuration.and_then(|it| it[role].as_array());
    for index in chosen.map_or(list(manager, "pdos"), Vec::as_slice) {
        writeln!(lines, "pdo {:04x}", index.as_u64().unwrap()).unwrap();
        let mapped = configuration.into_iter().flat_map(|it| list(it, "mapping"));
        let pdo = mapped.chain(list(member, "pdos")).find(|pdo| pdo["index"] == *index).unwrap();
        for entry in list(pdo, "entries") {
            let part = |key: &str| entry["address"][key].as_u64().unwrap_or(0);
            writeln!(lines, "entry {:04x} {:02x} {}", part("index"), part("subindex"), number(entry, "bits"))
                .unwrap();
        }
    }
}
