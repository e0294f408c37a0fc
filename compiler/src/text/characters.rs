//! What a text may hold: the one place that knows which characters a description has no use for.
//!
//! [`hazard`] is asked on the way in, for every key and every string of a description, and on the way out, for every
//! message and every output: what it names does not come in, and what would come by another way, such as the name of a
//! folder, does not go out as it is.

use std::borrow::Cow;
use std::fmt::Write as _;

/// What a character does that has no place in a text; none for one that only stands for itself.
///
/// A line feed and a tab may be in a text of several lines; a name that is one line has its own rules.
pub fn hazard(c: char) -> Option<&'static str> {
    match c {
        '\t' | '\n' | ' '..='~' => None,
        _ if c.is_control() => Some("a control character"),
        '\u{2028}' | '\u{2029}' => Some("a line break that few programs know"),
        // Bidi_Control in the tables of Unicode
        '\u{061C}' | '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}' => {
            Some("a mark that changes the direction in which text is read")
        }
        '\u{FDD0}'..='\u{FDEF}' => Some("no character at all"),
        _ if u32::from(c) & 0xFFFE == 0xFFFE => Some("no character at all"),
        // what of Cf nobody sees; the joiners U+200C and U+200D are needed to write some languages
        '\u{00AD}'
        | '\u{180E}'
        | '\u{200B}'
        | '\u{2060}'..='\u{2064}'
        | '\u{206A}'..='\u{206F}'
        | '\u{FEFF}'
        | '\u{FFF9}'..='\u{FFFB}'
        | '\u{E0000}'..='\u{E007F}' => Some("a character that cannot be seen"),
        _ => None,
    }
}

/// The text with what it may not hold written as `\u{1B}`, and line feeds as `\n`: one line for a terminal or a log.
pub fn line(text: &str) -> Cow<'_, str> {
    let is_marked = |c| c == '\n' || is_hazard(c);
    written(text, text.find(is_marked), is_marked, |c, out| match c {
        '\n' => out.push_str("\\n"),
        _ => {
            let _ = write!(out, "\\u{{{:X}}}", u32::from(c));
        }
    })
}

/// The text with what it may not hold replaced by �, which has the same width wherever it is shown.
pub fn harmless(text: &str) -> Cow<'_, str> {
    written(text, first_hazard(text), is_hazard, |_, out| out.push(char::REPLACEMENT_CHARACTER))
}

/// JSON with what its strings may not hold as escapes. Outside of strings JSON is plain ASCII, so all of it is in them.
pub fn json(text: &str) -> Cow<'_, str> {
    written(text, first_hazard(text), is_hazard, |c, out| {
        let mut units = [0; 2];
        for unit in c.encode_utf16(&mut units) {
            let _ = write!(out, "\\u{unit:04x}");
        }
    })
}

fn is_hazard(c: char) -> bool {
    hazard(c).is_some()
}

/// Where the first hazard of a text is, if it has one.
pub(crate) fn first_hazard(text: &str) -> Option<usize> {
    let mut at = 0;
    loop {
        at += plain(text.as_bytes().get(at..)?);
        let c = text.get(at..)?.chars().next()?;
        if is_hazard(c) {
            return Some(at);
        }
        at += c.len_utf8();
    }
}

/// How many bytes at the beginning are those of ASCII that only stand for themselves: nearly all, so many are asked at once.
fn plain(bytes: &[u8]) -> usize {
    let is_plain = |byte: &u8| matches!(byte, b'\t' | b'\n' | b' '..=b'~');
    let blocks =
        bytes.chunks_exact(64).take_while(|block| block.iter().fold(true, |all, byte| all & is_plain(byte)));
    let start = blocks.count() * 64;
    start + bytes.iter().skip(start).take_while(|byte| is_plain(byte)).count()
}

/// The text with each `marked` character, of which there is a first one or none, written by `write`.
fn written(
    text: &str,
    first: Option<usize>,
    marked: impl Fn(char) -> bool,
    write: impl Fn(char, &mut String),
) -> Cow<'_, str> {
    let Some(first) = first else { return Cow::Borrowed(text) };
    let (clean, rest) = text.split_at(first);
    let mut out = String::with_capacity(text.len() + 16);
    out.push_str(clean);
    for c in rest.chars() {
        if marked(c) { write(c, &mut out) } else { out.push(c) }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The categories of the Unicode standard that [`hazard`] is made of, by the first and last of each range.
    #[test]
    fn controls_and_marks_are_hazards() {
        let ranges = [
            ('\0', '\u{8}'),
            ('\u{B}', '\u{1F}'),
            ('\u{7F}', '\u{9F}'),
            ('\u{2028}', '\u{2029}'),
            ('\u{202A}', '\u{202E}'),
            ('\u{2066}', '\u{206F}'),
            ('\u{FDD0}', '\u{FDEF}'),
            ('\u{FFFE}', '\u{FFFF}'),
            ('\u{1FFFE}', '\u{1FFFF}'),
            ('\u{10FFFE}', '\u{10FFFF}'),
            ('\u{E0001}', '\u{E007F}'),
        ];
        for (first, last) in ranges {
            assert!((first..=last).all(|c| hazard(c).is_some()), "{first:?} to {last:?}");
        }
        assert!(
            "\u{AD}\u{61C}\u{180E}\u{200B}\u{200E}\u{200F}\u{2060}\u{FEFF}"
                .chars()
                .all(|c| hazard(c).is_some())
        );
    }

    #[test]
    fn writing_is_not() {
        let text = "Tab\t, line\n, µm, θ, °C, Größe, 速度, سرعت, می\u{200C}خواهم, 👩\u{200D}🔧, ✓\u{FE0F}, \u{E0100}, \u{E000}";
        assert_eq!(text.chars().find(|c| hazard(*c).is_some()), None);
        assert!(matches!(harmless(text), Cow::Borrowed(_)));
    }

    #[test]
    fn each_way_out_has_its_escapes() {
        let text = "a\u{1B}[31m\nb\u{202E}\u{E0001}";
        assert_eq!(line(text), "a\\u{1B}[31m\\nb\\u{202E}\\u{E0001}");
        assert_eq!(harmless(text), "a�[31m\nb��");
        assert_eq!(json("\"\u{7F}\u{E0001}\""), r#""\u007f\udb40\udc01""#);
    }
}
