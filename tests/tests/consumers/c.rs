//! The C headers: as C99 and as C++17 without a warning, and run under sanitizers.

use std::fmt::Write;
use std::path::Path;

use devc::emit::c::C;
use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::expected;
use crate::model::{Print, Record, Subject, list, records, subjects, text};
use crate::tools::{compare, run, tool};

pub(crate) const STRICT: [&str; 5] = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];

/// Names that C and C++ keep for themselves, of those that the corner has.
const KEYWORDS: [&str; 2] = ["class", "int"];

/// The compilers of C that are there.
pub(crate) fn compilers() -> impl Iterator<Item = &'static str> {
    [["gcc"], ["clang"]].iter().filter_map(|name| tool(name))
}

#[test]
fn headers_do_what_the_model_says() {
    let Some(compiler) = tool(&["gcc", "cc"]) else { return };
    let subjects = subjects();
    std::thread::scope(|scope| {
        for subject in &subjects {
            scope.spawn(move || subject.members.iter().for_each(|member| check(subject, member, compiler)));
        }
    });
}

fn check(subject: &Subject, member: &Json, compiler: &str) {
    let id = text(member, "id");
    let folder = tempfile::tempdir().unwrap();
    let files = C.emit(&subject.family, &Options::default());
    std::fs::write(folder.path().join("device.h"), &files.0[&format!("{id}.h")]).unwrap();
    let prefix = if subject.id == id { id.to_owned() } else { format!("{}_{id}", subject.id) };
    let records = records(member, &KEYWORDS);
    let program = program(&prefix.replace('-', "_"), member, &records);
    std::fs::write(folder.path().join("test.c"), program).unwrap();
    let what = |way: &str| format!("{id} {way}");
    let sanitized =
        ["-std=c99", "-O0", "-g0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-o", "test"];
    run(folder.path(), compiler, &[&STRICT[..], &sanitized, &["test.c"]].concat());
    compare(&what("in C"), &run(folder.path(), "./test", &[]), &expected::lines(member, &records));
    other_ways(folder.path());
}

/// Compiled as what it is not run as: by another compiler, and as C++ by both.
fn other_ways(folder: &Path) {
    let cpp = ["-x", "c++", "-std=c++17"];
    for (compiler, language) in [("clang", &["-std=c99"][..]), ("g++", &cpp), ("clang++", &cpp)] {
        if let Some(compiler) = tool(&[compiler]) {
            run(folder, compiler, &[&STRICT[..], language, &["-fsyntax-only", "test.c"]].concat());
        }
    }
}

const HEAD: &str = r#"#include "device.h"
#include <stdio.h>
#include <stdlib.h>

static void hex(const void *data, size_t size)
{
    const uint8_t *at = (const uint8_t *)data;
    for (; size > 0; size--) { printf("%02x", (unsigned)*at++); }
}

static void number(long long value)
{
    int byte;
    for (byte = 0; byte < 8; byte++) { printf("%02x", (unsigned)((unsigned long long)value >> (8 * byte)) & 0xFFu); }
}

/* Bytes at the end of what may be read, so that a sanitizer sees who reads further. */
static uint8_t *alone(const uint8_t *data, size_t size)
{
    uint8_t *copy = (uint8_t *)malloc(size > 0 ? size : 1);
    if (copy == NULL) { abort(); }
    memcpy(copy, data, size);
    return copy;
}

"#;

/// What the start-up lists are handed.
const TOLD: &str = r#"struct told { const char *list; int left; };

static int told(void *user, uint16_t index, uint8_t subindex, const uint8_t *data, int size)
{
    struct told *it = (struct told *)user;
    if (it->list == NULL) { return it->left-- == 0; }
    printf("W %s %04x %02x ", it->list, (unsigned)index, (unsigned)subindex);
    hex(data, (size_t)size);
    printf("\n");
    return 0;
}

"#;

/// A program that uses all of a header.
fn program(prefix: &str, member: &Json, records: &[Record]) -> String {
    let mut text = String::from(HEAD);
    if !expected::start_ups(member).is_empty() {
        text.push_str(TOLD);
    }
    let used: Vec<&Record> = records.iter().filter(|record| !record.fields.is_empty()).collect();
    used.iter().for_each(|record| one(prefix, record, &mut text));
    text.push_str("int main(void)\n{\n    long code;\n    (void)code;\n");
    for record in &used {
        writeln!(text, "    {}();", record.name).unwrap();
    }
    if list(member, "states").iter().any(|state| state["pattern"].is_string()) {
        text.push_str("    {\n        int before = -1;\n        for (code = 0; code < 65536; code++) {\n");
        writeln!(text, "            const int state = (int){prefix}_state_of((uint16_t)code);").unwrap();
        text.push_str("            if (state != before) { printf(\"S %04lx %d\\n\", code, state); }\n");
        text.push_str("            before = state;\n        }\n    }\n");
    }
    for (key, letter, function) in [("errors", "E", "error_name"), ("al_status_codes", "A", "al_status_name")]
    {
        if !list(member, key).is_empty() {
            writeln!(
                text,
                "    for (code = 0; code < 65536; code++) {{\n        const char *name = {prefix}_{function}((uint16_t)code);\n        \
                 if (*name != 0) {{ printf(\"{letter} %04lx %s\\n\", code, name); }}\n    }}"
            )
            .unwrap();
        }
    }
    for (name, writes) in expected::start_ups(member) {
        let refused = writes.len() / 2;
        writeln!(
            text,
            "    {{\n        struct told it = {{ \"{name}\", 0 }};\n        if ({prefix}_{name}(&it, told) != 0) {{ return 1; }}\n        \
             it.list = NULL;\n        it.left = {refused};\n        if ({prefix}_{name}(&it, told) != {refused} + 1) {{ return 2; }}\n    }}"
        )
        .unwrap();
    }
    text + "    return 0;\n}\n"
}

/// A function that unpacks samples, packs what came out, and prints both.
fn one(prefix: &str, record: &Record, text: &mut String) {
    let Record { name, .. } = record;
    let bytes = record.bytes();
    let samples = record.samples();
    writeln!(text, "static const uint8_t {name}_samples[{}][{bytes}] = {{", samples.len()).unwrap();
    for sample in &samples {
        let row: Vec<String> = sample.iter().map(u8::to_string).collect();
        writeln!(text, "    {{ {} }},", row.join(", ")).unwrap();
    }
    let upper = prefix.to_uppercase();
    let macro_name = format!("{upper}_{}_BYTES", name.to_uppercase());
    writeln!(
        text,
        "}};\nstatic void {name}(void)\n{{\n    int sample;\n    for (sample = 0; sample < {}; sample++) {{\n        \
         struct {prefix}_{name} it;\n        uint8_t out[{macro_name}];\n        \
         uint8_t *in = alone({name}_samples[sample], {macro_name});\n        memset(out, 0xAA, sizeof out);\n        \
         {prefix}_{name}_unpack(&it, in);\n        free(in);\n        {prefix}_{name}_pack(out, &it);\n        \
         printf(\"R {name} \");\n        hex(out, sizeof out);",
        samples.len()
    )
    .unwrap();
    for field in &record.fields {
        let path = &field.path;
        let print = match field.print() {
            Print::Number => format!("number((long long)it.{path})"),
            Print::Real | Print::Bytes => format!("hex(&it.{path}, sizeof it.{path})"),
        };
        writeln!(text, "        printf(\" \");\n        {print};").unwrap();
    }
    text.push_str("        printf(\"\\n\");\n    }\n}\n\n");
}
