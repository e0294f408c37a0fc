//! The bytes of a file as text.
//!
//! ESI files are UTF-8 or ISO-8859-1, and some say one and are the other: what is UTF-8 throughout is taken for that.
//! UTF-16, which XML allows as well, is known by its first bytes.

use std::borrow::Cow;

/// The text of a file, or why it is none.
pub(super) fn text(bytes: &[u8]) -> Result<Cow<'_, str>, &'static str> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    match bytes {
        [0xFF, 0xFE, 0, 0, ..] | [0, 0, 0xFE, 0xFF, ..] => {
            return Err("it is UTF-32; save it as UTF-8 first");
        }
        [0xFF, 0xFE, rest @ ..] => return Ok(Cow::Owned(utf_16(rest, u16::from_le_bytes))),
        [0xFE, 0xFF, rest @ ..] => return Ok(Cow::Owned(utf_16(rest, u16::from_be_bytes))),
        [b'<', 0, ..] => return Ok(Cow::Owned(utf_16(bytes, u16::from_le_bytes))),
        [0, b'<', ..] => return Ok(Cow::Owned(utf_16(bytes, u16::from_be_bytes))),
        _ => {}
    }
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Ok(Cow::Borrowed(text));
    }
    Ok(Cow::Owned(bytes.iter().map(|byte| windows_1252(*byte)).collect()))
}

/// Units of 16 bits; what is none of Unicode's stands there as �.
fn utf_16(bytes: &[u8], unit: impl Fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks_exact(2).filter_map(|pair| pair.try_into().ok().map(&unit));
    char::decode_utf16(units).map(|char| char.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

/// Windows-1252, which is ISO-8859-1 but for 32 places that ISO-8859-1 leaves to control characters.
fn windows_1252(byte: u8) -> char {
    const HIGH: [char; 32] = [
        '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8D}', 'Ž', '\u{8F}',
        '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9D}', 'ž', 'Ÿ',
    ];
    let high = byte.checked_sub(0x80).and_then(|place| HIGH.get(usize::from(place)));
    high.copied().unwrap_or(char::from(byte))
}
