//! Texts as Python holds them, and the words that it keeps for itself.

use std::fmt::Write;

use minijinja::Environment;

/// Words of Python, types that fields are declared with, and what classes made here have besides fields.
pub(super) const KEYWORDS: &[&str] = &[
    "and",
    "as",
    "assert",
    "async",
    "await",
    "break",
    "case",
    "class",
    "continue",
    "def",
    "del",
    "elif",
    "else",
    "except",
    "false",
    "finally",
    "for",
    "from",
    "global",
    "if",
    "import",
    "in",
    "is",
    "lambda",
    "match",
    "mro",
    "none",
    "nonlocal",
    "not",
    "or",
    "pass",
    "print",
    "raise",
    "return",
    "true",
    "try",
    "type",
    "while",
    "with",
    "yield",
    "at",
    "bool",
    "bytes",
    "classmethod",
    "cls",
    "count",
    "data",
    "float",
    "index",
    "int",
    "pack",
    "raw",
    "self",
    "unpack",
];

/// What the template needs to write texts.
pub(super) fn filters(environment: &mut Environment<'static>) {
    environment.add_filter("string", |text: String| string(&text));
    environment.add_filter("bytes", |bytes: Vec<u64>| -> String {
        let bytes: String = bytes.iter().map(|byte| format!("\\x{byte:02x}")).collect();
        format!("b\"{bytes}\"")
    });
}

/// A text as a literal.
fn string(text: &str) -> String {
    let mut literal = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => literal.extend(['\\', c]),
            // Writing to a String cannot fail.
            _ if c.is_control() => _ = write!(literal, "\\x{:02x}", u32::from(c) & 0xFF),
            _ => literal.push(c),
        }
    }
    literal.push('"');
    literal
}
