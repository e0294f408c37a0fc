//! Findings that a team knows of and does not want to see again.
//!
//! A finding is known by its rule, its file and its message, not by its line, so that edits elsewhere in the
//! file do not bring it back.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use devc::Compilation;
use devc::diagnostic::Diagnostic;
use devc::source::MAX_SIZE;
use serde::{Deserialize, Serialize};

use super::draft::Draft;
use super::existing;
use super::outcome::Failure;
use super::report::Report;
use super::workplace::{Workplace, folder};

/// The version of the format; a file of another one may mean something else.
const VERSION: u32 = 1;

/// The known findings, each with how often it is known.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Baseline(BTreeMap<Finding, usize>);

#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
struct Finding {
    rule: String,
    file: String,
    message: String,
}

#[derive(Deserialize)]
struct Head {
    version: u32,
}

#[derive(Serialize, Deserialize)]
struct Document {
    version: u32,
    findings: Vec<Finding>,
}

impl Baseline {
    /// Reads a baseline.
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let missing = || {
            Failure::new(format!("the baseline `{}` does not exist", path.display()))
                .help("`devc check --update-baseline` makes the file")
        };
        let document = document(&target(path))?.ok_or_else(missing)?;
        let mut baseline = Self::default();
        for finding in document.findings {
            *baseline.0.entry(finding).or_default() += 1;
        }
        Ok(baseline)
    }

    /// Writes the baseline; what lies there has to be one, and not one of a later devc.
    pub(super) fn write(&self, path: &Path, report: &Report) -> Result<(), Failure> {
        let path = target(path);
        let place = Workplace::enter(folder(&path), report);
        let repeated =
            self.0.iter().flat_map(|(finding, count)| std::iter::repeat_n(finding.clone(), *count));
        let document = Document { version: VERSION, findings: repeated.collect() };
        let text = serde_json::to_string_pretty(&document).unwrap_or_default() + "\n";
        existing::be_writable(&path)?;
        let draft = Draft::write(&place, &path, &text)?;
        self::document(&path)?;
        draft.publish()
    }

    /// How many findings there are.
    pub(super) fn len(&self) -> usize {
        self.0.values().sum()
    }

    /// Takes in what a compilation found; faults that stop it are never known.
    pub(super) fn learn(&mut self, compilation: &Compilation) {
        for diagnostic in compilation.diagnostics.iter().filter(|diagnostic| !diagnostic.rule.fixed) {
            *self.0.entry(finding(diagnostic, compilation)).or_default() += 1;
        }
    }

    /// Takes the known findings out of a compilation, each as often as it is known.
    pub(super) fn forget(&mut self, compilation: &mut Compilation) {
        let diagnostics = std::mem::take(&mut compilation.diagnostics);
        let new: Vec<Diagnostic> = diagnostics
            .into_iter()
            .filter(|diagnostic| {
                let known = self.0.get_mut(&finding(diagnostic, compilation)).filter(|count| **count > 0);
                known.map(|count| *count -= 1).is_none()
            })
            .collect();
        compilation.diagnostics.extend(new);
    }
}

/// The file that is meant: a link that leads to one stays a link.
fn target(path: &Path) -> PathBuf {
    let is_link = fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_symlink());
    fs::canonicalize(path).ok().filter(|_| is_link).unwrap_or_else(|| path.to_owned())
}

/// What the file says, if there is one.
fn document(path: &Path) -> Result<Option<Document>, Failure> {
    let Some(bytes) = existing::read(path, MAX_SIZE + 1)? else { return Ok(None) };
    let failure = |why: String| {
        Failure::new(format!("`{}` is not a baseline: {why}", path.display()))
            .help("name another file with `--baseline`")
    };
    if bytes.len() > MAX_SIZE {
        return Err(failure(format!("it is larger than {} MiB", MAX_SIZE >> 20)));
    }
    let head: Head = serde_json::from_slice(&bytes).map_err(|error| failure(error.to_string()))?;
    if head.version != VERSION {
        return Err(failure(format!(
            "its version is {}, and this devc knows version {VERSION}",
            head.version
        )));
    }
    serde_json::from_slice(&bytes).map(Some).map_err(|error| failure(error.to_string()))
}

fn finding(diagnostic: &Diagnostic, compilation: &Compilation) -> Finding {
    let file = diagnostic.at().and_then(|at| compilation.sources.get(at.file));
    Finding {
        rule: diagnostic.rule.name.to_owned(),
        file: file.map(|file| file.path.clone()).unwrap_or_default(),
        message: diagnostic.message.clone(),
    }
}
