//! Backslashes.

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
