//! Which descriptions a command is about.

use std::fs;
use std::io::{self, ErrorKind};
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

/// The given paths, each once, a folder of descriptions as these; without any, the description in this folder, or those
/// in `devices`.
pub(super) fn files(given: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    if given.is_empty() {
        return match is_there(Path::new(MAIN_FILE)) {
            true => Ok(vec![PathBuf::from(".")]),
            false => shipped(&root().unwrap_or_default().join(DEVICES)),
        };
    }
    let mut seen = Vec::new();
    let mut paths = Vec::new();
    for path in given.iter().flat_map(|path| or_within(path)) {
        let canonical = fs::canonicalize(&path).unwrap_or_else(|_| path.clone());
        if !seen.contains(&canonical) {
            seen.push(canonical);
            paths.push(path);
        }
    }
    Ok(paths)
}

/// A description, or those in a folder that is none itself; what holds none is reported when it is read.
fn or_within(path: &Path) -> Vec<PathBuf> {
    if is_there(&path.join(MAIN_FILE)) {
        return vec![path.to_owned()];
    }
    within(path).ok().filter(|within| !within.is_empty()).unwrap_or_else(|| vec![path.to_owned()])
}

/// The descriptions in `devices`, of which there is at least one.
fn shipped(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let help = "name the folder of a description, or run devc in it or where the folder `devices` lies; \
                `devc new NAME` begins one";
    let paths = within(folder).map_err(|error| Failure::at("look into", folder, &error).help(help))?;
    match paths.is_empty() {
        true => Err(Failure::new(format!("no folder in `{DEVICES}` holds a `{MAIN_FILE}`")).help(help)),
        false => Ok(paths),
    }
}

/// Every folder in `folder` that holds a description, by name.
fn within(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries: Vec<fs::DirEntry> = fs::read_dir(folder)?.collect::<Result<_, _>>()?;
    let mut paths: Vec<PathBuf> = entries.iter().map(fs::DirEntry::path).collect();
    paths.retain(|path| is_there(&path.join(MAIN_FILE)));
    paths.sort();
    Ok(paths)
}

/// What is there and cannot be read is reported when it is read.
fn is_there(file: &Path) -> bool {
    match fs::symlink_metadata(file) {
        Err(error) => !matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory),
        Ok(_) => true,
    }
}
