//! Names of outputs.

use devc::text::files;

use super::outcome::Failure;

/// The name of an output, if it can be one wherever it is checked out.
pub(super) fn portable(name: &str) -> Result<&str, Failure> {
    let Some(fault) = files::fault(name) else { return Ok(name) };
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

#[cfg(test)]
mod tests {
    use super::*;

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
