//! `devc fmt`

use std::path::{Path, PathBuf};

use clap::Args;
use devc::diagnostic::Diagnostics;
use devc::format::format;
use devc::source::{Disk, Sources, load};

use super::edited::{self, Edited};
use super::outcome::{Failure, Outcome};
use super::paths::files;
use super::report::Report;

/// Lay out the files of descriptions: order of keys and sections, alignment, forms of numbers, blank lines.
///
/// Comments and the line breaks of lists stay, and so does what the files say. A file that is not TOML is left alone.
#[derive(Debug, Args)]
pub(super) struct Fmt {
    /// Folders with a `device.toml`, for all files of the description, or single TOML files [default: every such folder
    /// in `devices`].
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// Write nothing; say which files are not laid out.
    #[arg(long)]
    check: bool,
}

/// A file with its layout.
struct Laid {
    shown: String,
    file: Edited,
}

impl Fmt {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let mut outcome = Outcome::Clean;
        for path in files(&self.paths)? {
            let end = self.one(&path, report);
            outcome = outcome.max(end.unwrap_or_else(|failure| report.failure(&failure)));
        }
        Ok(outcome)
    }

    /// A description, or a file of one.
    fn one(&self, path: &Path, report: &Report) -> Result<Outcome, Failure> {
        let (laid, mut outcome) = lay_out(path, report);
        if self.check {
            for Laid { shown, file } in &laid {
                let line = first_difference(&file.old, &file.new);
                report.error(&format!("`{shown}` is not laid out, from line {line} on"), None);
                outcome = outcome.max(Outcome::Findings);
            }
            return Ok(outcome);
        }
        let (names, files): (Vec<String>, Vec<Edited>) =
            laid.into_iter().map(|laid| (laid.shown, laid.file)).unzip();
        edited::write(&files, report)?;
        names.iter().for_each(|name| report.line(&format!("{name}: laid out")));
        Ok(outcome)
    }
}

/// The files that look different when they are laid out; what is said of the others is about what is not TOML.
fn lay_out(path: &Path, report: &Report) -> (Vec<Laid>, Outcome) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let read = load(&Disk, path, &[], &mut sources, &mut diagnostics);
    if read.is_none() && sources.iter().next().is_none() {
        diagnostics.finish();
        report.found(&diagnostics, &sources);
        return (Vec::new(), Outcome::Failed);
    }
    let is_file = path.extension().is_some_and(|extension| extension == "toml");
    let files = sources.iter().take(if is_file { 1 } else { usize::MAX });
    let mut outcome = Outcome::Clean;
    let mut laid = Vec::new();
    for (id, file) in files {
        let Some(name) = sources.name(id) else { continue };
        match format(&file.path, &file.text) {
            Ok(new) if new == file.text => {}
            Ok(new) => {
                let edited = Edited { name: name.to_owned(), old: file.text.clone(), new };
                laid.push(Laid { shown: file.path.clone(), file: edited });
            }
            Err((diagnostics, sources)) => {
                report.found(&diagnostics, &sources);
                outcome = Outcome::Findings;
            }
        }
    }
    (laid, outcome)
}

/// The line from which on two texts differ, counted from 1.
fn first_difference(old: &str, new: &str) -> usize {
    1 + old.lines().zip(new.lines()).take_while(|(old, new)| old == new).count()
}
