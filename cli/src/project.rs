//! The `devc.toml` of the folder that devc runs in, or the nearest above it, as Cargo finds its configuration.

use std::fs;
use std::path::{Path, PathBuf};

use devc::emit::{self, Emitter};
use devc::project::{Outputs, PROJECT_FILE, read};
use devc::source::Disk;

use super::outcome::Failure;
use super::report::Report;

/// What a project wants, and where it is.
#[derive(Debug, Default)]
pub(super) struct Project {
    /// The folder of the file; the one devc runs in, as an empty path, where there is none.
    pub(super) root: PathBuf,
    /// The file, if there is one.
    pub(super) file: Option<PathBuf>,
    pub(super) outputs: Outputs,
}

impl Project {
    /// What holds here.
    pub(super) fn here(report: &Report) -> Result<Self, Failure> {
        let Some(root) = root() else { return Ok(Self::default()) };
        let file = root.join(PROJECT_FILE);
        let found = read(&Disk, &file);
        report.found(&found.diagnostics, &found.sources);
        if found.diagnostics.has_errors() {
            return Err(Failure::new(format!("`{}` does not say what is wanted", file.display())));
        }
        Ok(Self { root, file: Some(file), outputs: found.outputs })
    }

    /// The outputs that it names; those that are made of themselves where it names none.
    pub(super) fn emitters(&self) -> Vec<&'static dyn Emitter> {
        match &self.outputs.emit {
            Some(words) => emit::wanted(words.iter().map(|word| word.0)),
            None => emit::default().collect(),
        }
    }

    /// The outputs whose rules are asked where none is made: of themselves, and those that it names.
    pub(super) fn checked(&self) -> Vec<&'static dyn Emitter> {
        let words = self.outputs.emit.iter().flatten().map(|word| word.0);
        emit::wanted(words.chain([emit::DEFAULT]))
    }
}

/// The folder of the nearest file, as a path from here; none if there is no file.
pub(super) fn root() -> Option<PathBuf> {
    let here = std::env::current_dir().ok()?;
    let ups = (0..here.components().count()).map(|up| (0..up).map(|_| "..").collect::<PathBuf>());
    ups.into_iter().find(|folder: &PathBuf| is_there(&folder.join(PROJECT_FILE)))
}

/// What is there and cannot be read is said when it is read.
fn is_there(file: &Path) -> bool {
    fs::symlink_metadata(file).is_ok()
}
