//! Texts as Structured Text holds them, and the words that it keeps for itself.

use std::fmt::Write;

use minijinja::Environment;

/// Words of the third edition of IEC 61131-3, with its functions and types, and of TwinCAT and CODESYS.
pub(super) const KEYWORDS: &[&str] = &[
    "ABS",
    "ABSTRACT",
    "ACOS",
    "ACTION",
    "ADD",
    "AND",
    "AND_THEN",
    "ANY",
    "ANY_BIT",
    "ANY_CHAR",
    "ANY_CHARS",
    "ANY_DATE",
    "ANY_DERIVED",
    "ANY_DURATION",
    "ANY_ELEMENTARY",
    "ANY_INT",
    "ANY_MAGNITUDE",
    "ANY_NUM",
    "ANY_REAL",
    "ANY_SIGNED",
    "ANY_STRING",
    "ANY_UNSIGNED",
    "ARRAY",
    "ASIN",
    "AT",
    "ATAN",
    "BIT",
    "BOOL",
    "BY",
    "BYTE",
    "CAL",
    "CALC",
    "CASE",
    "CHAR",
    "CLASS",
    "CONCAT",
    "CONFIGURATION",
    "CONSTANT",
    "CONTINUE",
    "COS",
    "CTD",
    "CTU",
    "CTUD",
    "DATE",
    "DATE_AND_TIME",
    "DELETE",
    "DINT",
    "DIV",
    "DO",
    "DT",
    "DWORD",
    "ELSE",
    "ELSIF",
    "EN",
    "END_ACTION",
    "END_CASE",
    "END_CLASS",
    "END_CONFIGURATION",
    "END_FOR",
    "END_FUNCTION",
    "END_FUNCTION_BLOCK",
    "END_IF",
    "END_INTERFACE",
    "END_METHOD",
    "END_NAMESPACE",
    "END_PROGRAM",
    "END_PROPERTY",
    "END_REPEAT",
    "END_RESOURCE",
    "END_STEP",
    "END_STRUCT",
    "END_TRANSITION",
    "END_TYPE",
    "END_UNION",
    "END_VAR",
    "END_WHILE",
    "ENO",
    "EQ",
    "EXIT",
    "EXP",
    "EXPT",
    "EXTENDS",
    "FALSE",
    "FINAL",
    "FIND",
    "FOR",
    "FROM",
    "FUNCTION",
    "FUNCTION_BLOCK",
    "F_EDGE",
    "F_TRIG",
    "GE",
    "GET",
    "GT",
    "IF",
    "IMPLEMENTS",
    "IN",
    "INITIAL_STEP",
    "INSERT",
    "INT",
    "INTERFACE",
    "INTERNAL",
    "INTERVAL",
    "JMP",
    "LD",
    "LDATE",
    "LDT",
    "LE",
    "LEFT",
    "LEN",
    "LIMIT",
    "LINT",
    "LN",
    "LOG",
    "LREAL",
    "LT",
    "LTIME",
    "LTOD",
    "LWORD",
    "MAX",
    "METHOD",
    "MID",
    "MIN",
    "MOD",
    "MOVE",
    "MUL",
    "MUX",
    "NAMESPACE",
    "NE",
    "NON_RETAIN",
    "NOT",
    "NULL",
    "OF",
    "ON",
    "OR",
    "OR_ELSE",
    "OVERLAP",
    "OVERRIDE",
    "PERSISTENT",
    "POINTER",
    "PRIORITY",
    "PRIVATE",
    "PROGRAM",
    "PROPERTY",
    "PROTECTED",
    "PUBLIC",
    "R",
    "READ_ONLY",
    "READ_WRITE",
    "REAL",
    "REF",
    "REFERENCE",
    "REF_TO",
    "REPEAT",
    "REPLACE",
    "RESOURCE",
    "RET",
    "RETAIN",
    "RETURN",
    "RIGHT",
    "ROL",
    "ROR",
    "RS",
    "R_EDGE",
    "R_TRIG",
    "S",
    "SEL",
    "SET",
    "SHL",
    "SHR",
    "SIN",
    "SINGLE",
    "SINT",
    "SQRT",
    "SR",
    "ST",
    "STD",
    "STEP",
    "STRING",
    "STRUCT",
    "SUB",
    "SUPER",
    "TAN",
    "TASK",
    "THEN",
    "THIS",
    "TIME",
    "TIME_OF_DAY",
    "TO",
    "TOD",
    "TOF",
    "TON",
    "TP",
    "TRANSITION",
    "TRUE",
    "TRUNC",
    "TYPE",
    "UDINT",
    "UINT",
    "ULINT",
    "UNION",
    "UNTIL",
    "USING",
    "USINT",
    "VAR",
    "VAR_ACCESS",
    "VAR_CONFIG",
    "VAR_EXTERNAL",
    "VAR_GLOBAL",
    "VAR_INPUT",
    "VAR_INST",
    "VAR_IN_OUT",
    "VAR_OUTPUT",
    "VAR_STAT",
    "VAR_TEMP",
    "WCHAR",
    "WHILE",
    "WITH",
    "WORD",
    "WSTRING",
    "XOR",
];

/// What the template needs to write texts.
pub(super) fn filters(environment: &mut Environment<'static>) {
    environment.add_filter("based", |number: u64, digits: usize| format!("16#{number:0digits$X}"));
    environment.add_filter("comment", |text: String| comment(&text));
    environment.add_filter("string", |text: String| string(&text));
    environment.add_filter("bytes", |bytes: Vec<u64>, size: usize| -> String {
        let bytes = bytes.into_iter().chain(std::iter::repeat(0)).take(size);
        bytes.map(|byte| format!("16#{byte:02X}")).collect::<Vec<_>>().join(", ")
    });
    environment.add_filter("bits", |bits: u64| match bits {
        ..=8 => "BYTE",
        9..=16 => "WORD",
        17..=32 => "DWORD",
        _ => "LWORD",
    });
}

/// A text within a comment: neither its end nor that of a pragma, nor another beginning.
fn comment(text: &str) -> String {
    let mut parted = String::with_capacity(text.len());
    for c in text.chars() {
        if (parted.ends_with('*') && c == ')') || (parted.ends_with('(') && c == '*') {
            parted.push(' ');
        }
        parted.push(c);
    }
    parted
}

/// A text as a literal of single bytes, in Latin 1.
fn string(text: &str) -> String {
    let mut literal = String::from('\'');
    for c in text.chars() {
        match c {
            '\'' | '$' => literal.extend(['$', c]),
            ' '..='~' => literal.push(c),
            // Writing to a String cannot fail.
            '\u{A0}'..='\u{FF}' => _ = write!(literal, "${:02X}", u32::from(c)),
            _ => literal.push('?'),
        }
    }
    literal.push('\'');
    literal
}

#[cfg(test)]
mod tests {
    use super::{comment, string};

    #[test]
    fn no_text_leaves_its_comment_or_literal() {
        for text in ["a *) b", "(*)", "**))", "((*", "*))"] {
            let comment = comment(text);
            assert!(!comment.contains("*)") && !comment.contains("(*"), "{comment}");
        }
        assert_eq!(string("it's 5 $ \u{B5} \u{3A9}"), "'it$'s 5 $$ $B5 ?'");
    }
}
