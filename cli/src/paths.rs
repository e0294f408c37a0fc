//! Which descriptions a command is about.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use devc::source::MAIN_FILE;

use super::outcome::Failure;

/// The folder that is looked into if no path is given.
const DEVICES: &str = "devices";

/// The given paths, each once; without any, every folder under `devices` that holds a description.
pub(super) fn descriptions(given: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    if given.is_empty() {
        return shipped(Path::new(DEVICES));
    }
    let mut seen = Vec::new();
    let mut paths = Vec::new();
    for path in given {
        let canonical = fs::canonicalize(path).unwrap_or_else(|_| path.clone());
        if !seen.contains(&canonical) {
            seen.push(canonical);
            paths.push(path.clone());
        }
    }
    Ok(paths)
}

/// Every folder in `folder` that holds a description, by name.
fn shipped(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let help = "name the folder of a description, or run devc where the folder `devices` lies";
    let entries =
        fs::read_dir(folder).map_err(|error| Failure::at("look into", folder, &error).help(help))?;
    let mut paths = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| Failure::at("look into", folder, &error))?.path();
        // What is there and cannot be read is reported when it is read.
        match fs::symlink_metadata(path.join(MAIN_FILE)) {
            Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {}
            _ => paths.push(path),
        }
    }
    paths.sort();
    match paths.is_empty() {
        true => Err(Failure::new(format!("no folder in `{DEVICES}` holds a `{MAIN_FILE}`")).help(help)),
        false => Ok(paths),
    }
}
