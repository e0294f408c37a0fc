//! Markdown within a line.

use std::fmt::Display;

use crate::emit::escape::escape;

/// Text that means itself: whatever Markdown or HTML would read into it is escaped, and it is one line, so
/// that it also fits a cell of a table.
pub(crate) fn text(plain: &str) -> String {
    let mut out = String::with_capacity(plain.len() + plain.len() / 8);
    append(plain, &mut out);
    out
}

/// Writes a text that means itself.
pub(super) fn append(plain: &str, out: &mut String) {
    for (place, word) in plain.split_whitespace().enumerate() {
        if place > 0 {
            out.push(' ');
        } else if out.is_empty() && begins_block(word) {
            let end = word.len() - word.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            out.push_str(word.get(..end).unwrap_or_default());
            out.push('\\');
            out.push_str(word.get(end..).unwrap_or_default());
            continue;
        }
        let last = word.len().saturating_sub(1);
        let is_markup = |place, byte| match byte {
            b'\\' | b'`' | b'*' | b'[' | b']' | b'<' | b'|' | b'~' | b'$' | b'&' => true,
            // Within a word an underscore is one.
            b'_' => place == 0 || place == last,
            _ => false,
        };
        escape(word, is_markup, out);
    }
}

/// Whether a line that begins with this word would be a heading, a quotation, a list or a rule.
fn begins_block(word: &str) -> bool {
    let all = |sign: char| word.chars().all(|c| c == sign);
    let number = word.trim_end_matches(['.', ')']);
    let is_item = number.len() + 1 == word.len() && number.bytes().all(|byte| byte.is_ascii_digit());
    "#-+=".chars().any(all) || word.starts_with('>') || is_item && !number.is_empty()
}

/// A value as it is to be typed: `0x6040`.
pub(super) fn code(value: impl Display) -> String {
    let value = value.to_string();
    if value.contains(['`', '|', '\n']) { text(&value) } else { format!("`{value}`") }
}

/// A link to a place in the document.
pub(super) fn link(label: impl Display, anchor: impl Display) -> String {
    format!("[{label}](#{})", fragment(anchor))
}

/// A place that links can lead to.
pub(super) fn anchor(id: impl Display) -> String {
    format!("<a id=\"{}\"></a>", fragment(id))
}

/// The name of a place, with `_` and its number for each character that could end an attribute, a link or a cell.
pub(super) fn fragment(id: impl Display) -> String {
    let mut out = String::new();
    for c in id.to_string().chars() {
        match c {
            '-' | '.' | '_' | ':' => out.push(c),
            _ if c.is_alphanumeric() => out.push(c),
            _ => out += &format!("_{:x}", u32::from(c)),
        }
    }
    out
}

/// Small print.
pub(super) fn small(markdown: &str) -> String {
    if markdown.is_empty() { String::new() } else { format!("<sub>{markdown}</sub>") }
}

/// A sentence with a capital at its front and a full stop at its end.
pub(super) fn sentence(markdown: &str) -> String {
    let mut chars = markdown.chars();
    let Some(first) = chars.next() else { return String::new() };
    let end = if markdown.ends_with(['.', '!', '?', ':']) { "" } else { "." };
    format!("{}{}{end}", first.to_uppercase(), chars.as_str())
}

/// Things in a row: `a, b and c`.
pub(super) fn list(items: impl IntoIterator<Item = String>) -> String {
    items.into_iter().collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_means_itself_and_fits_a_cell() {
        assert_eq!(text("a | b\nc <br> *d*"), r"a \| b c \<br> \*d\*");
        assert_eq!(text("_x_ a_b"), r"\_x\_ a_b");
        assert_eq!(text("3 & $4 [x]"), r"3 \& \$4 \[x\]");
    }

    #[test]
    fn text_begins_no_block() {
        assert_eq!(text("# a # b"), r"\# a # b");
        assert_eq!(text("- a - b"), r"\- a - b");
        assert_eq!(text("1. a"), r"1\. a");
        assert_eq!(text("> a"), r"\> a");
        assert_eq!(text("-5 V, 1.5 A"), "-5 V, 1.5 A");
    }

    #[test]
    fn code_that_would_break_its_span_is_text() {
        assert_eq!(code("0x6040"), "`0x6040`");
        assert_eq!(code("a|b"), r"a\|b");
    }

    #[test]
    fn a_link_leads_to_its_anchor_whatever_it_is_called() {
        assert_eq!(anchor("doc-a\"><b>|(c)"), "<a id=\"doc-a_22_3e_3cb_3e_7c_28c_29\"></a>");
        assert_eq!(link("A", "doc-a)b"), "[A](#doc-a_29b)");
        assert_eq!(link("A", "unit-größe.2"), "[A](#unit-größe.2)");
    }

    #[test]
    fn sentences_begin_and_end() {
        assert_eq!(sentence("the drive stops"), "The drive stops.");
        assert_eq!(sentence("Stop!"), "Stop!");
        assert_eq!(sentence(""), "");
    }
}
