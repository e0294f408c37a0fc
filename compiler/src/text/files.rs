//! Names that a file can have on every machine.

/// The longest name that file systems take, in bytes.
const MAX_LENGTH: usize = 255;

/// Names that Windows keeps for devices, with any extension and in any case.
const RESERVED: &[&str] = &["con", "prn", "aux", "nul", "conin$", "conout$"];

/// Why a file cannot have a name on every machine, if it cannot.
pub fn fault(name: &str) -> Option<String> {
    let forbidden =
        |c: char| c.is_control() || matches!(c, '/' | '\\' | ':' | '*' | '?' | '"' | '<' | '>' | '|');
    if matches!(name, "" | "." | "..") {
        return Some("it is no name".to_owned());
    }
    if name.contains(char::REPLACEMENT_CHARACTER) {
        return Some("it is not UTF-8".to_owned());
    }
    if let Some(c) = name.chars().find(|c| forbidden(*c)) {
        return Some(format!("it has {c:?}, which not every system takes"));
    }
    if name.ends_with(['.', ' ']) {
        return Some("it ends with a dot or a space, which not every system keeps".to_owned());
    }
    if name.len() > MAX_LENGTH {
        return Some(format!("it has more than {MAX_LENGTH} bytes"));
    }
    is_reserved(name).then(|| "Windows keeps it for a device".to_owned())
}

fn is_reserved(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or(name).trim_end().to_ascii_lowercase();
    let numbered = stem.strip_prefix("com").or_else(|| stem.strip_prefix("lpt"));
    RESERVED.contains(&&*stem)
        || numbered.is_some_and(|number| matches!(number, "¹" | "²" | "³"))
        || numbered
            .is_some_and(|number| number.len() == 1 && number.bytes().all(|byte| byte.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// After "Naming Files, Paths, and Namespaces" of the Windows documentation.
    #[test]
    fn what_some_system_does_not_take_is_no_name() {
        for name in [
            "",
            ".",
            "..",
            "a/b",
            "a\\b",
            "a:b",
            "a\nb",
            "a?",
            "a.",
            "a ",
            "con",
            "Aux.xml",
            "COM1",
            "lpt9.rs",
            "com²",
            "nul.tar.gz",
        ] {
            assert!(fault(name).is_some(), "{name:?}");
        }
        assert!(fault(&"a".repeat(256)).is_some());
        for name in ["c887", ".a", "a b", "com", "com10", "console", "Größe", "a.b.xml", &"a".repeat(255)] {
            assert!(fault(name).is_none(), "{name:?}");
        }
    }
}
