//! What texts need before they stand in an output: backslashes, and hyphens apart.
//!
//! What no output can hold at all, [`text::characters`](crate::text::characters) says.

/// Writes a text with a backslash before each of its bytes, given with their places, that is `marked`; only bytes of
/// ASCII may be.
pub(super) fn escape(text: &str, marked: impl Fn(usize, u8) -> bool, out: &mut String) {
    let mut written = 0;
    for (place, byte) in text.bytes().enumerate() {
        if marked(place, byte) {
            out.push_str(text.get(written..place).unwrap_or_default());
            out.push('\\');
            written = place;
        }
    }
    out.push_str(text.get(written..).unwrap_or_default());
}

/// A text in several lines as one line.
#[cfg(any(feature = "esi", feature = "eds", feature = "program"))]
pub(super) fn prose(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A text as a comment of XML or HTML can hold it: two hyphens would end it, so a space parts them.
#[cfg(any(feature = "esi", feature = "lcec", feature = "markdown"))]
pub(super) fn comment(text: &str) -> String {
    let mut parted = String::with_capacity(text.len());
    for c in text.chars() {
        if c == '-' && parted.ends_with('-') {
            parted.push(' ');
        }
        parted.push(c);
    }
    parted
}
