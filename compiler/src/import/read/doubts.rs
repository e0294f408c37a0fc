//! What of a file may not be read as it is meant: its encoding, and entities of its own.

use super::element::At;

/// The encodings that are read, in small letters and without the signs between them.
const KNOWN: [&str; 9] =
    ["utf8", "utf16", "utf16le", "utf16be", "iso88591", "latin1", "windows1252", "cp1252", "usascii"];

/// Each doubt with its place, what it is about, and what was done.
pub(in super::super) fn doubts(bytes: &[u8], text: &str) -> Vec<(At, &'static str, String)> {
    let encoding = declared(text).filter(|name| std::str::from_utf8(bytes).is_err() && !is_known(name));
    let encoding = encoding.map(|name| {
        let why = format!("`{name}` is none that is read; Windows-1252 is taken, so other letters are wrong");
        (At(0), "the encoding", why)
    });
    let entity = text.find("<!ENTITY").map(|at| {
        (
            At(at),
            "entities",
            "none of a file's own is followed; where one is named stands its name".to_owned(),
        )
    });
    encoding.into_iter().chain(entity).collect()
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
