//! Paths as editors name them.

use std::path::{Path, PathBuf};

/// The path of a `file:` address; none for another kind of address.
pub(super) fn path(uri: &str) -> Option<PathBuf> {
    let rest = uri.strip_prefix("file://")?;
    let path = rest.get(rest.find('/')?..)?;
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let digits = [rest.next()?, rest.next()?];
        bytes.push(u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 16).ok()?);
    }
    let text = String::from_utf8(bytes).ok()?;
    // `/C:/folder` of Windows
    let is_drive = text.get(2..3) == Some(":");
    Some(PathBuf::from(if is_drive && cfg!(windows) { text.get(1..)? } else { &text }))
}

/// The `file:` address of a path.
pub(super) fn uri(path: &Path) -> String {
    let text = path.to_string_lossy().replace('\\', if cfg!(windows) { "/" } else { "\\" });
    let mut uri = String::from(if text.starts_with('/') { "file://" } else { "file:///" });
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'/' => {
                uri.push(byte.into())
            }
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_lead_back() {
        for name in ["/a/b.toml", "/ä b/%20/#?.toml"] {
            assert_eq!(path(&uri(Path::new(name))), Some(PathBuf::from(name)), "{name}");
        }
        assert_eq!(path("file://localhost/a%C3%A4"), Some(PathBuf::from("/aä")));
        assert_eq!(path("untitled:Untitled-1"), None);
        assert_eq!(path("file:///a%G0"), None);
    }
}
