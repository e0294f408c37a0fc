//! `devc init`

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use devc::reference::SCHEMA;
use devc::source::{MAX_SIZE, plain};

use super::outcome::{Failure, Outcome};
use super::report::Report;

/// The files of a repository that has descriptions.
const FILES: &[(&str, &str)] = &[
    (".github/workflows/devc.yml", include_str!("init/devc.yml")),
    (".gitignore", include_str!("init/gitignore")),
    (".gitattributes", include_str!("init/gitattributes")),
    ("device.schema.json", SCHEMA),
];

/// Prepare a repository for descriptions: a workflow for GitHub, rules for git, the schema for editors.
///
/// What is there stays as it is: for a file that is there already, devc prints what could be added to it.
#[derive(Debug, Args)]
pub(super) struct Init {
    /// The root of the repository.
    #[arg(value_name = "DIR", default_value = ".")]
    folder: PathBuf,
}

impl Init {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        if !self.folder.is_dir() {
            return Err(Failure::new(format!("`{}` is not a folder", self.folder.display()))
                .help("name the root of a repository"));
        }
        for (name, text) in FILES {
            let path = self.folder.join(name);
            if create(&path, text)? {
                report.line(&format!("{}: written", path.display()));
            } else if !has(&path, text) {
                report.line(&format!("{}: is there, and stays as it is", path.display()));
                self.suggest(name, text, report);
            }
        }
        report.line("a first line `#:schema ../../device.schema.json` in `devices/<name>/device.toml` tells editors the schema");
        Ok(Outcome::Clean)
    }

    /// Prints what a file could have besides what it has; a schema is replaced as a whole or not at all.
    fn suggest(&self, name: &str, text: &str, report: &Report) {
        if name.ends_with(".json") {
            return report.line("`devc schema` prints the schema of this version of devc");
        }
        report.line("add to it what is not there yet:");
        text.lines().for_each(|line| report.line(&format!("    {line}")));
    }
}

/// Whether the file has all lines of a text.
fn has(path: &Path, text: &str) -> bool {
    let there = plain::read(path, MAX_SIZE as u64).unwrap_or_default();
    let there = String::from_utf8_lossy(&there);
    text.lines().all(|line| there.lines().any(|other| other == line))
}

/// Writes a file that is not there; false if something is.
fn create(path: &Path, text: &str) -> Result<bool, Failure> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|error| Failure::at("make the folder", folder, &error))?;
    }
    match OpenOptions::new().write(true).create_new(true).open(path) {
        Ok(mut file) => {
            file.write_all(text.as_bytes()).map_err(|error| Failure::at("write", path, &error))?;
            Ok(true)
        }
        Err(error) if error.kind() == ErrorKind::AlreadyExists => Ok(false),
        Err(error) => Err(Failure::at("write", path, &error)),
    }
}
