//! What an output consists of, whatever its texts say: for outputs that are programs, and for data sheets.

#![allow(clippy::panic, clippy::indexing_slicing)] // a test may

/// The tokens of a program without comments: names and texts by their kind, all else by what it is. Texts are told by their
/// quote and what escapes it.
pub(super) fn program(text: &str, comment: (&str, &str), (quote, escape): (char, char)) -> Vec<String> {
    let (mut tokens, mut rest) = (Vec::new(), text);
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let (token, end) = if rest.starts_with(comment.0) {
            let end = rest
                .get(1..)
                .and_then(|inner| inner.find(comment.1))
                .unwrap_or_else(|| panic!("a comment ends"));
            ("", 1 + end + comment.1.len())
        } else if first == quote {
            ("text", literal(rest, quote, escape))
        } else if is_word(first) {
            let kind = if first.is_ascii_digit() { "number" } else { "name" };
            (kind, rest.find(|c| !is_word(c)).unwrap_or(rest.len()))
        } else {
            let end = first.len_utf8();
            (if first.is_whitespace() { "" } else { &rest[..end] }, end)
        };
        if !token.is_empty() {
            tokens.push(token.to_owned());
        }
        rest = &rest[end..];
    }
    tokens
}

/// The length of the literal that a text begins with; it ends in its line.
fn literal(text: &str, quote: char, escape: char) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        assert!(c != '\n', "a text ends in its line: {text:.60}");
        if c == quote && !escaped {
            return at + 1;
        }
        escaped = c == escape && !escaped;
    }
    panic!("a text ends");
}

/// Sections and keys of a data sheet, without what follows from texts in them.
pub(super) fn sheet(text: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| !line.is_empty() && !line.starts_with(';'));
    lines.map(|line| line.split_once('=').map_or(line, |(key, _)| key).to_owned()).collect()
}
