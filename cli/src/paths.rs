//! Which descriptions a command is about.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use devc::source::{Disk, MAIN_FILE, owner};
use devc::text::characters::line;

use super::outcome::Failure;
use super::project::root;
use super::report::Report;

/// The folder that is looked into if no path is given, beside `devc.toml` if there is one.
const DEVICES: &str = "devices";

/// The given paths as [`files`] has them, but for a file that a description includes the description, which is said.
pub(super) fn descriptions(given: &[PathBuf], report: &Report) -> Result<Vec<PathBuf>, Failure> {
    let whole = |path: &PathBuf| {
        let is_file = path.extension().is_some_and(|extension| extension == "toml");
        let Some(main) = is_file.then(|| owner(&Disk, path)).flatten() else { return path.clone() };
        let (file, main) = (path.display(), main);
        report.message(&line(&format!(
            "`{file}` is a part of `{}`, which is taken as a whole",
            main.display()
        )));
        match main.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
            _ => main,
        }
    };
    files(&given.iter().map(whole).collect::<Vec<_>>())
}

/// The given paths, each once; without any, the description in this folder, or every folder under `devices` that holds one.
pub(super) fn files(given: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    if given.is_empty() {
        return match Path::new(MAIN_FILE).exists() {
            true => Ok(vec![PathBuf::from(".")]),
            false => shipped(&root().unwrap_or_default().join(DEVICES)),
        };
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
    let help = "name the folder of a description, or run devc in it or where the folder `devices` lies; `devc new NAME` begins one";
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
