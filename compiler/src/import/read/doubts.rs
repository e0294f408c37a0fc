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

/// Whether bytes are not what a file says, or leaves to be taken: UTF-8. Then they are taken for those of Windows-1252.
pub(in super::super) fn is_miscoded(bytes: &[u8], text: &str) -> bool {
    let is_units = bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") || bytes.contains(&0);
    let says_utf_8 = declared(text).is_none_or(|name| letters(name) == "utf8");
    says_utf_8 && !is_units && std::str::from_utf8(bytes).is_err()
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
    KNOWN.contains(&letters(name).as_str())
}

fn letters(name: &str) -> String {
    name.chars().filter(|char| char.is_ascii_alphanumeric()).map(|char| char.to_ascii_lowercase()).collect()
}
