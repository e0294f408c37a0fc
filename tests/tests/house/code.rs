//! Rust as it was written, without what is not the crate's own code.

use std::path::Path;

/// A file in which comments, texts, tests and the code that `quote!` makes are blank, so that all else stays where it
/// was.
pub(crate) struct Code {
    /// Its path in the workspace, with `/` between folders.
    pub(crate) path: String,
    pub(crate) text: String,
}

impl Code {
    pub(crate) fn new(path: &Path, text: &str) -> Self {
        let parts: Vec<_> = path.components().map(|part| part.as_os_str().to_string_lossy()).collect();
        let mut bytes = without_literals(text.as_bytes());
        for head in ["#[cfg(test)]", "quote!"] {
            blank_behind(&mut bytes, head);
        }
        Self { path: parts.join("/"), text: String::from_utf8(bytes).expect("text stays text") }
    }

    /// Whether all of it is tests.
    pub(crate) fn is_test(&self) -> bool {
        self.path.ends_with("/tests.rs")
    }

    /// The line of a byte, counted from 1.
    pub(crate) fn line(&self, offset: usize) -> usize {
        1 + self.text[..offset].matches('\n').count()
    }

    /// The words and the signs between them, with their places.
    pub(crate) fn tokens(&self) -> Vec<(&str, usize)> {
        let mut tokens = Vec::new();
        let mut rest = self.text.as_str();
        while let Some(first) = rest.chars().next() {
            let is_word = |char: char| char.is_alphanumeric() || char == '_';
            let length = match rest.find(|char| !is_word(char)) {
                Some(0) if rest.starts_with("::") => 2,
                Some(0) => first.len_utf8(),
                length => length.unwrap_or(rest.len()),
            };
            if !first.is_whitespace() {
                tokens.push((&rest[..length], self.text.len() - rest.len()));
            }
            rest = &rest[length..];
        }
        tokens
    }
}

/// Where the bracket closes that opens at `start`.
pub(crate) fn closing(text: &[u8], start: usize) -> usize {
    let mut depth = 0_i32;
    for (place, byte) in text.iter().enumerate().skip(start) {
        depth += i32::from(b"([{".contains(byte)) - i32::from(b")]}".contains(byte));
        if depth == 0 {
            return place;
        }
    }
    text.len() - 1
}

fn without_literals(text: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(text.len());
    while let Some(byte) = text.get(out.len()) {
        match literal(text, out.len()) {
            Some(end) => out.extend(text[out.len()..end].iter().map(|byte| blank(*byte))),
            None => out.push(*byte),
        }
    }
    out
}

fn blank(byte: u8) -> u8 {
    if byte == b'\n' { byte } else { b' ' }
}

/// Where the comment, the text or the character ends that begins here, if one does.
fn literal(text: &[u8], start: usize) -> Option<usize> {
    let rest = &text[start..];
    let find = |what: &[u8]| rest.windows(what.len()).position(|window| window == what);
    let length = match rest {
        [b'/', b'/', ..] => find(b"\n").unwrap_or(rest.len()),
        [b'/', b'*', ..] => find(b"*/")? + 2,
        [b'"', ..] => quoted(rest, b'"')?,
        [b'r', b'"' | b'#', ..] => raw(rest)?,
        [b'\'', b'\\', ..] => quoted(rest, b'\'')?,
        [b'\'', ..] => {
            let char = std::str::from_utf8(&rest[1..rest.len().min(5)]);
            let char = char.unwrap_or_else(|error| {
                std::str::from_utf8(&rest[1..1 + error.valid_up_to()]).expect("what is valid")
            });
            let length = char.chars().next()?.len_utf8();
            (rest.get(1 + length) == Some(&b'\'')).then_some(length + 2)?
        }
        _ => return None,
    };
    Some(start + length)
}

/// The length of a text in which a backslash takes the next byte along.
fn quoted(text: &[u8], quote: u8) -> Option<usize> {
    let mut place = 1;
    while *text.get(place)? != quote {
        place += if text[place] == b'\\' { 2 } else { 1 };
    }
    Some(place + 1)
}

/// The length of a text such as `r#""#`.
fn raw(text: &[u8]) -> Option<usize> {
    let hashes = text[1..].iter().take_while(|byte| **byte == b'#').count();
    (text.get(1 + hashes) == Some(&b'"')).then_some(())?;
    let end: Vec<u8> = std::iter::once(b'"').chain(std::iter::repeat_n(b'#', hashes)).collect();
    let body = &text[hashes + 2..];
    let length = body.windows(end.len()).position(|window| window == end)?;
    Some(hashes + 2 + length + end.len())
}

/// Blanks what stands behind `head`: the item under an attribute, or what a macro is given.
fn blank_behind(text: &mut [u8], head: &str) {
    let mut start = 0;
    while let Some(found) = text[start..].windows(head.len()).position(|window| window == head.as_bytes()) {
        let head_end = start + found + head.len();
        let first = text[head_end..].iter().position(|byte| b"([{;".contains(byte));
        let Some(first) = first.map(|first| head_end + first) else { break };
        let end = if text[first] == b';' { first } else { closing(text, first) };
        text[head_end..=end].iter_mut().for_each(|byte| *byte = blank(*byte));
        start = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<String> {
        let code = Code::new(Path::new("a.rs"), text);
        assert_eq!(code.text.len(), text.len());
        code.tokens().into_iter().map(|(word, _)| word.to_owned()).collect()
    }

    #[test]
    fn comments_and_texts_are_no_code() {
        assert_eq!(words("a // b\nc /* d */ e \"f \\\" g\" h"), ["a", "c", "e", "h"]);
        assert_eq!(words("r#\"a \" b\"# 'c' '\\'' 'µ' d"), ["d"]);
        assert_eq!(words("fn a<'b>()"), ["fn", "a", "<", "'", "b", ">", "(", ")"]);
    }

    #[test]
    fn tests_and_quoted_code_are_not_the_crates_own() {
        assert_eq!(words("#[cfg(test)]\nmod a;\nb"), ["#", "[", "cfg", "(", "test", ")", "]", "b"]);
        assert_eq!(words("#[cfg(test)] mod a { fn b() {} } c").last().map(String::as_str), Some("c"));
        assert_eq!(words("quote!(crate::a) b"), ["quote", "!", "b"]);
    }
}
