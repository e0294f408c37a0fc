//! Descriptions as they were in a revision of git.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use devc::source::{MAIN_FILE, Memory};

use super::outcome::Failure;

/// The TOML files of a description's folder in a revision, and the path of the description among them:
/// `main:devices/c887`.
pub(super) fn description(revision: &str, path: &Path) -> Result<(Memory, PathBuf), Failure> {
    let (folder, file) = match path.extension() {
        Some(extension) if extension == "toml" => (path.parent().unwrap_or(Path::new("")), path.file_name()),
        _ => (path, None),
    };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    // A name that looks like an option is none.
    let commit = git(
        folder,
        &["rev-parse", "--verify", "--quiet", "--end-of-options", &format!("{revision}^{{commit}}")],
    )
    .map_err(|why| {
        Failure::new(format!("git knows no revision `{revision}` of `{}`", path.display())).maybe_help(why)
    })?;
    let commit = commit.trim();
    let shown = PathBuf::from(format!("{revision}:{}", folder.display()));
    let names = git(folder, &["ls-tree", "-r", "-z", "--name-only", commit, "--", "."])
        .map_err(|why| Failure::new(format!("git cannot list `{}`", shown.display())).maybe_help(why))?;
    let mut memory = Memory::new();
    for name in names.split('\0').filter(|name| name.ends_with(".toml")) {
        let text = git(folder, &["cat-file", "blob", &format!("{commit}:./{name}")]).map_err(|why| {
            Failure::new(format!("git cannot read `{}`", shown.join(name).display())).maybe_help(why)
        })?;
        memory = memory.with(shown.join(name), text);
    }
    let main = file.unwrap_or(OsStr::new(MAIN_FILE));
    Ok((memory, shown.join(main)))
}

/// What git says in a folder, or what it complains of.
fn git(folder: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new("git").arg("-C").arg(folder).args(arguments).output();
    let output = output.map_err(|error| format!("git cannot be run: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned());
    }
    String::from_utf8(output.stdout).map_err(|_| "it is not UTF-8".to_owned())
}
