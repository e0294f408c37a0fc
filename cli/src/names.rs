//! Names that a file can have on every machine.

use super::outcome::Failure;

/// The longest name that file systems take, in bytes.
const MAX_LENGTH: usize = 255;

/// Names that Windows keeps for devices, with any extension and in any case.
const RESERVED: &[&str] = &["con", "prn", "aux", "nul", "conin$", "conout$"];

/// The name of an output, if it can be one wherever it is checked out.
pub(super) fn portable(name: &str) -> Result<&str, Failure> {
    let Some(fault) = fault(name) else { return Ok(name) };
    // as in a string, so that what nobody can see is seen
    Err(Failure::new(format!("{name:?} cannot be the name of an output: {fault}"))
        .help("rename the folder of the description: outputs take their name from it"))
}

/// The name of an output within the folder of its family, if it can be one wherever it is checked out: a file, or a file in a
/// folder.
pub(super) fn portable_path(path: &str) -> Result<&str, Failure> {
    match path.split_once('/') {
        Some((folder, name)) => portable(folder).and(portable(name)).map(|_| path),
        None => portable(path),
    }
}

fn fault(name: &str) -> Option<String> {
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
            assert!(portable(name).is_err(), "{name:?}");
        }
        assert!(portable(&"a".repeat(256)).is_err());
        for name in ["c887", ".a", "a b", "com", "com10", "console", "Größe", "a.b.xml", &"a".repeat(255)] {
            assert!(portable(name).is_ok(), "{name:?}");
        }
    }

    #[test]
    fn a_file_can_be_in_one_folder() {
        for path in ["a.md", "c887.soes/utypes.h"] {
            assert!(portable_path(path).is_ok(), "{path:?}");
        }
        for path in ["../a", "a/..", "/a", "a/", "a/b/c", "aux/b", "a/b?"] {
            assert!(portable_path(path).is_err(), "{path:?}");
        }
    }
}
