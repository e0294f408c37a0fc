//! Findings that a team knows of and does not want to see again.
//!
//! A finding is known by its rule, its file and its message, not by its line, so that edits elsewhere in the
//! file do not bring it back.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use devc::Compilation;
use devc::diagnostic::Diagnostic;
use serde::{Deserialize, Serialize};

use super::draft;
use super::outcome::Failure;

/// The known findings, each with how often it is known.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Baseline(BTreeMap<Finding, usize>);

#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
struct Finding {
    rule: String,
    file: String,
    message: String,
}

#[derive(Serialize, Deserialize)]
struct Document {
    version: u32,
    findings: Vec<Finding>,
}

impl Baseline {
    /// Reads a baseline.
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let text = fs::read_to_string(path).map_err(|error| {
            Failure::at("read", path, &error).help("`devc check --update-baseline` makes the file")
        })?;
        let document: Document = serde_json::from_str(&text)
            .map_err(|error| Failure::new(format!("`{}` is not a baseline: {error}", path.display())))?;
        let mut baseline = Self::default();
        for finding in document.findings {
            *baseline.0.entry(finding).or_default() += 1;
        }
        Ok(baseline)
    }

    /// Writes the baseline.
    pub(super) fn write(&self, path: &Path) -> Result<(), Failure> {
        let repeated =
            self.0.iter().flat_map(|(finding, count)| std::iter::repeat_n(finding.clone(), *count));
        let document = Document { version: 1, findings: repeated.collect() };
        let text = serde_json::to_string_pretty(&document).unwrap_or_default() + "\n";
        draft::replace(path, &text)
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

fn finding(diagnostic: &Diagnostic, compilation: &Compilation) -> Finding {
    let file = diagnostic.at().and_then(|at| compilation.sources.get(at.file));
    Finding {
        rule: diagnostic.rule.name.to_owned(),
        file: file.map(|file| file.path.clone()).unwrap_or_default(),
        message: diagnostic.message.clone(),
    }
}
