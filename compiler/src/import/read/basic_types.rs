//! Basic types by their numbers and by the words that IgH has for them.

/// The name and the width of a type by its number: CiA 301, data type definitions, and ETG.1020, base data types.
pub(super) fn of_code(code: u16) -> Option<(String, Option<u32>)> {
    let sized = |name: &str, bits: u32| Some((format!("{name}{bits}"), Some(bits)));
    match code {
        0x01 => Some(("BOOL".to_owned(), Some(1))),
        0x02 => sized("INT", 8),
        0x03 => sized("INT", 16),
        0x04 => sized("INT", 32),
        0x05 => sized("UINT", 8),
        0x06 => sized("UINT", 16),
        0x07 => sized("UINT", 32),
        0x08 => sized("REAL", 32),
        0x09 => Some(("STRING".to_owned(), None)),
        0x0A => Some(("OCTET_STRING".to_owned(), None)),
        0x0B => Some(("UNICODE_STRING".to_owned(), None)),
        0x10 => sized("INT", 24),
        0x11 => sized("REAL", 64),
        0x12..=0x15 => sized("INT", 40 + 8 * u32::from(code - 0x12)),
        0x16 => sized("UINT", 24),
        0x18..=0x1B => sized("UINT", 40 + 8 * u32::from(code - 0x18)),
        0x1E => Some(("BYTE".to_owned(), Some(8))),
        0x1F => Some(("WORD".to_owned(), Some(16))),
        0x20 => Some(("DWORD".to_owned(), Some(32))),
        0x30..=0x37 => sized("BIT", 1 + u32::from(code - 0x30)),
        _ => None,
    }
}

/// A string of bytes or of units of 16 bits with its length, where its width tells it.
pub(super) fn sized(name: String, bits: Option<u32>) -> String {
    match (name.as_str(), bits) {
        ("OCTET_STRING", Some(bits)) => format!("{name}({})", bits / 8),
        ("UNICODE_STRING", Some(bits)) => format!("{name}({})", bits / 16),
        _ => name,
    }
}

/// The name of a type by the word that IgH's master prints for it, or by the number where it has none.
pub(super) fn of_word(word: &str) -> String {
    let plain = match word {
        "bool" => "BOOL",
        "float" => "REAL32",
        "double" => "REAL64",
        "string" => "STRING",
        "octet_string" => "OCTET_STRING",
        "unicode_string" => "UNICODE_STRING",
        _ => "",
    };
    let code = word.strip_prefix("type ").and_then(|digits| u16::from_str_radix(digits.trim(), 16).ok());
    match code {
        _ if !plain.is_empty() => plain.to_owned(),
        Some(code) => of_code(code).map_or_else(|| word.to_owned(), |(name, _)| name),
        None => word.to_uppercase(),
    }
}
