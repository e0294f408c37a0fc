//! Where a file holds characters that no text may hold.

use std::ops::Range;

use crate::text::characters::{first_hazard, hazard};

/// A character that has no business where it stands.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Odd {
    pub(super) c: char,
    /// What is wrong with it.
    pub(super) what: &'static str,
    /// Its bytes, or those of the escape that stands for it.
    pub(super) at: Range<usize>,
}

/// Those that stand in a file as they are, comments included. Controls of ASCII are not among them: that they are not
/// TOML says the parser.
pub(super) fn raw(text: &str) -> impl Iterator<Item = Odd> {
    let clean = first_hazard(text).unwrap_or(text.len());
    let mark = if text.starts_with('\u{FEFF}') { '\u{FEFF}'.len_utf8() } else { 0 };
    let rest = text.get(clean..).unwrap_or_default().char_indices().map(move |(at, c)| (clean + at, c));
    let beyond = rest.filter(move |(at, c)| !c.is_ascii() && *at >= mark);
    beyond.filter_map(|(at, c)| Some(Odd { c, what: hazard(c)?, at: at..at + c.len_utf8() }))
}

/// Those that a key or a string stands for by escapes, given as it is written; a key can hold no tab and no line feed
/// either.
pub(super) fn escaped(written: &str, is_key: bool) -> Vec<Odd> {
    let what = |c| match c {
        '\n' if is_key => Some("a line feed"),
        '\t' if is_key => Some("a tab"),
        _ => hazard(c),
    };
    let literal = !written.starts_with('"');
    let mut odd = Vec::new();
    let mut rest = written.char_indices();
    while let Some((start, c)) = rest.next() {
        let c = if c == '\\' && !literal { escape(&mut rest) } else { Some(c).filter(|c| *c == '\t') };
        // as Windows ends a line
        let windows = c == Some('\r') && rest.as_str().starts_with("\\n");
        if let Some((c, what)) = c.and_then(|c| Some((c, what(c)?))).filter(|_| !windows) {
            odd.push(Odd { c, what, at: start..rest.offset() });
        }
    }
    odd
}

/// The character that is meant by what stands behind a backslash.
fn escape(rest: &mut std::str::CharIndices<'_>) -> Option<char> {
    let digits = match rest.next()?.1 {
        'b' => return Some('\u{8}'),
        'e' => return Some('\u{1B}'),
        'f' => return Some('\u{C}'),
        'n' => return Some('\n'),
        'r' => return Some('\r'),
        't' => return Some('\t'),
        'x' => 2,
        'u' => 4,
        'U' => 8,
        _ => return None,
    };
    let code = rest.as_str().get(..digits)?;
    rest.nth(digits - 1);
    u32::from_str_radix(code, 16).ok().and_then(char::from_u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(odd: impl IntoIterator<Item = Odd>) -> Vec<(char, Range<usize>)> {
        odd.into_iter().map(|odd| (odd.c, odd.at)).collect()
    }

    #[test]
    fn raw_characters_have_their_bytes() {
        assert_eq!(
            found(raw("\u{FEFF}a = 1 # \u{202E}b\u{85}\n")),
            [('\u{202E}', 11..14), ('\u{85}', 15..17)]
        );
    }

    #[test]
    fn escapes_are_what_they_mean() {
        assert_eq!(found(escaped(r#""a\u001Bb\x7f\\u0000""#, false)), [('\u{1B}', 2..8), ('\u{7F}', 9..13)]);
        assert_eq!(found(escaped(r#""\e\U000E0041""#, false)), [('\u{1B}', 1..3), ('\u{E0041}', 3..13)]);
        assert_eq!(found(escaped(r"'\u001B'", false)), []);
        assert_eq!(found(escaped(r#""\r\n, \r""#, false)), [('\r', 7..9)]);
        assert_eq!(found(escaped(r#""\n\t""#, false)), []);
        assert_eq!(found(escaped(r#""\n	""#, true)), [('\n', 1..3), ('\t', 3..4)]);
        assert_eq!(found(escaped(r#""\u12""#, false)), []);
    }
}
