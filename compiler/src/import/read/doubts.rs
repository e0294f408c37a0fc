//! What of a file is not read as it is meant: an encoding that is not known, and entities of its own.

use super::element::At;

/// The encodings that are read, in small letters and without the signs between them.
const KNOWN: [&str; 9] =
    ["utf8", "utf16", "utf16le", "utf16be", "iso88591", "latin1", "windows1252", "cp1252", "usascii"];

/// The encoding in which a file says that it is, if it is not known and the bytes are not UTF-8. Taken for another one, names
/// would be others.
pub(in super::super) fn foreign<'t>(bytes: &[u8], text: &'t str) -> Option<&'t str> {
    declared(text).filter(|name| std::str::from_utf8(bytes).is_err() && !is_known(name))
}

/// Entities that are not followed, with their place and what was done.
pub(in super::super) fn entities(text: &str) -> Option<(At, &'static str)> {
    let at = text.find("<!ENTITY")?;
    Some((At(at), "none of a file's own is followed; where one is named stands its name"))
}

/// What the declaration of XML says of the encoding.
fn declared(text: &str) -> Option<&str> {
    let (declaration, _) = text.trim_start().strip_prefix("<?xml")?.split_once("?>")?;
    let (_, rest) = declaration.split_once("encoding")?;
    let quoted = rest.trim_start().strip_prefix('=')?.trim_start();
    quoted.get(1..)?.split(['"', '\'']).next()
}

fn is_known(name: &str) -> bool {
    let letters: String = name
        .chars()
        .filter(|char| char.is_ascii_alphanumeric())
        .map(|char| char.to_ascii_lowercase())
        .collect();
    KNOWN.contains(&letters.as_str())
}
