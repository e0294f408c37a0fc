//! Texts as C holds them, and the words that it keeps for itself.

use std::fmt::Write;

use minijinja::Environment;

/// Words of C up to C23 and of C++ up to C++20, and names that their headers define as macros.
pub(in crate::emit) const KEYWORDS: &[&str] = &[
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "char8_t",
    "char16_t",
    "char32_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "dynamic_cast",
    "else",
    "enum",
    "errno",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "for",
    "friend",
    "goto",
    "if",
    "inline",
    "int",
    "linux",
    "long",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "typeof",
    "typeof_unqual",
    "union",
    "unix",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
];

/// What the template needs to write texts.
pub(in crate::emit) fn filters(environment: &mut Environment<'static>) {
    environment.add_filter("comment", |text: String| comment(&text));
    environment.add_filter("string", |text: String| string(&text));
    environment.add_filter("bytes", |bytes: Vec<u64>| -> String {
        bytes.iter().map(|byte| format!("0x{byte:02X}, ")).collect()
    });
}

/// A text within a comment: neither its end nor another beginning is in it, nor what continues a line.
fn comment(text: &str) -> String {
    let parted = text.replace("*/", "* /").replace("/*", "/ *").replace("??/", "?? /").replace('\\', "/");
    parted.replace("*/", "* /").replace("/*", "/ *")
}

/// A text as a literal: other than ASCII by its bytes in UTF-8, and no trigraphs.
fn string(text: &str) -> String {
    let mut literal = String::from('"');
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' | b'?' => literal.extend(['\\', char::from(byte)]),
            b' '..=b'~' => literal.push(char::from(byte)),
            // Writing to a String cannot fail.
            _ => _ = write!(literal, "\\{byte:03o}"),
        }
    }
    literal.push('"');
    literal
}

#[cfg(test)]
mod tests {
    use super::{comment, string};

    #[test]
    fn no_text_leaves_its_comment_or_literal() {
        for text in ["a */ b", "a /*/ b", "**//", "\\*\\/", "a \\", "??/", "/\\*"] {
            let comment = comment(text);
            assert!(
                !comment.contains("*/") && !comment.contains("/*") && !comment.contains('\\'),
                "{comment}"
            );
        }
        assert_eq!(string("\"µ\\?"), "\"\\\"\\302\\265\\\\\\?\"");
    }
}
